// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/color_space.h"

#include <array>
#include <bit>
#include <stdexcept>
#include <string>

#include "perception/multiversion.h"
#include "perception/simd.h"

namespace hindsight {
namespace {

/// Fifth root of x in (0, 1] by Newton's method from above, so that the C library is not asked.
constexpr double fifth_root(double x) {
  double y = 1.0;
  for (int i = 0; i < 60; ++i) y = (4.0 * y + x / (y * y * y * y)) / 5.0;
  return y;
}

/// IEC 61966-2-1: the light that a byte of sRGB stands for, 0..1; ((v + 0.055) / 1.055)^2.4 = u^2 *
/// (u^2)^(1/5).
constexpr double linear_light(int byte) {
  const double v = byte / 255.0;
  if (v <= 0.04045) return v / 12.92;
  const double u = (v + 0.055) / 1.055;
  return u * u * fifth_root(u * u);
}

template <typename T>
constexpr std::array<T, 256> make_linear_table() {
  std::array<T, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = static_cast<T>(linear_light(static_cast<int>(i)));
  return table;
}
constexpr std::array<double, 256> kLinear = make_linear_table<double>();
constexpr std::array<float, 256> kLinearFloat = make_linear_table<float>();

/// sRGB to XYZ, each row divided by the D65 white point, so that white is (1, 1, 1).
constexpr double kWhiteX = 0.950456, kWhiteZ = 1.088754;
constexpr double kToXyz[3][3] = {{0.412453 / kWhiteX, 0.357580 / kWhiteX, 0.180423 / kWhiteX},
                                 {0.212671, 0.715160, 0.072169},
                                 {0.019334 / kWhiteZ, 0.119193 / kWhiteZ, 0.950227 / kWhiteZ}};

constexpr double kLinearBelow = 216.0 / 24389.0;  ///< (6/29)^3: CIE 1976's f is a straight line below it
constexpr double kLineSlope = 841.0 / 108.0;      ///< (29/6)^2 / 3
constexpr double kLineOffset = 4.0 / 29.0;

double cube_root(double t) {
  double y = std::bit_cast<double>(std::bit_cast<std::uint64_t>(t) / 3 + 0x2A9F7893782DA1CEull);
  for (int i = 0; i < 4; ++i) y = (2.0 * y + t / (y * y)) / 3.0;
  return y;
}

double cie_f(double t) { return t > kLinearBelow ? cube_root(t) : t * kLineSlope + kLineOffset; }

Eigen::Vector3d lab_of(std::uint8_t b, std::uint8_t g, std::uint8_t r) {
  double f[3];
  for (int k = 0; k < 3; ++k)
    f[k] = cie_f(kToXyz[k][0] * kLinear[r] + kToXyz[k][1] * kLinear[g] + kToXyz[k][2] * kLinear[b]);
  return {116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])};
}

/// cie_f. Halley's method triples the good digits of the guess, which is within 4 %, at each of two steps.
inline void cie_f(Floats& t) {
  Ints bits;
  std::memcpy(&bits, &t, sizeof bits);
  bits = __builtin_convertvector(__builtin_convertvector(bits, Floats) * (1.0f / 3.0f), Ints) + 0x2A5137A0;
  Floats y;
  std::memcpy(&y, &bits, sizeof y);
  for (int step = 0; step < 2; ++step) {
    const Floats cube = y * y * y;
    y = y * ((cube + 2.0f * t) / (2.0f * cube + t));
  }
  const Floats line = t * static_cast<float>(kLineSlope) + static_cast<float>(kLineOffset);
  t = t > static_cast<float>(kLinearBelow) ? y : line;
}

/// From linear (B, G, R) in out[0..2] to (L*, a*, b*), count rounded up to whole vectors.
HINDSIGHT_MULTIVERSION void labs_from_linear(int count, float* const out[3]) {
  for (int i = 0; i < count; i += static_cast<int>(kLanes)) {
    Floats b, g, r, f[3];
    load(b, out[0] + i), load(g, out[1] + i), load(r, out[2] + i);
    for (int k = 0; k < 3; ++k) {
      f[k] = static_cast<float>(kToXyz[k][0]) * r + static_cast<float>(kToXyz[k][1]) * g +
             static_cast<float>(kToXyz[k][2]) * b;
      cie_f(f[k]);
    }
    store(out[0] + i, 116.0f * f[1] - 16.0f);
    store(out[1] + i, 500.0f * (f[0] - f[1]));
    store(out[2] + i, 200.0f * (f[1] - f[2]));
  }
}

void labs_of(const std::uint32_t* keys, int count, float* const out[3]) {
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) out[k][i] = kLinearFloat[keys[i] >> (8 * k) & 255];
  }
  labs_from_linear(count, out);
}

void rgbs_of(const std::uint32_t* keys, int count, float* const out[3]) {
  for (int i = 0; i < count; ++i) {
    out[0][i] = static_cast<float>(keys[i] >> 16 & 255);
    out[1][i] = static_cast<float>(keys[i] >> 8 & 255);
    out[2][i] = static_cast<float>(keys[i] & 255);
  }
}

}  // namespace

ColorSpace parse_color_space(std::string_view name) {
  if (name == "rgb") return ColorSpace::rgb;
  if (name == "lab") return ColorSpace::lab;
  throw std::invalid_argument("unknown colour space '" + std::string(name) + "', expected rgb or lab");
}

Eigen::Vector3d color_of(ColorSpace space, std::uint8_t b, std::uint8_t g, std::uint8_t r) {
  if (space == ColorSpace::lab) return lab_of(b, g, r);
  return {static_cast<double>(r), static_cast<double>(g), static_cast<double>(b)};
}

void colors_of(ColorSpace space, const std::uint32_t* keys, int count, float* const out[3]) {
  if (space == ColorSpace::lab) {
    labs_of(keys, count, out);
  } else {
    rgbs_of(keys, count, out);
  }
}

double color_float_error(ColorSpace space) { return space == ColorSpace::lab ? 3e-4 : 0.0; }

}  // namespace hindsight
