// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/tiled_noise.h"

#include <cmath>

namespace hindsight {
namespace {

/// A number for each corner of the grid (lowbias32, C. Wellons).
float corner(int x, int y, std::uint32_t seed) {
  std::uint32_t h =
      static_cast<std::uint32_t>(x) * 0x9E3779B9U ^ static_cast<std::uint32_t>(y) * 0x85EBCA6BU ^ seed;
  h = (h ^ (h >> 16U)) * 0x7FEB352DU;
  h = (h ^ (h >> 15U)) * 0x846CA68BU;
  h ^= h >> 16U;
  return static_cast<float>(h >> 8U) * 0x1p-24F;
}

float smooth(float t) { return t * t * (3.0F - 2.0F * t); }
float mix(float a, float b, float t) { return a + (b - a) * t; }

}  // namespace

float tiled_noise(float x, float y, int period, std::uint32_t seed) {
  const float fx = std::floor(x), fy = std::floor(y);
  const int mask = period - 1;
  const int x0 = static_cast<int>(fx) & mask, y0 = static_cast<int>(fy) & mask;
  const int x1 = (x0 + 1) & mask, y1 = (y0 + 1) & mask;
  const float tx = smooth(x - fx), ty = smooth(y - fy);
  return mix(mix(corner(x0, y0, seed), corner(x1, y0, seed), tx),
             mix(corner(x0, y1, seed), corner(x1, y1, seed), tx), ty);
}

float tiled_fractal(float x, float y, int period, int octaves, std::uint32_t seed) {
  float sum = 0.0F, weight = 1.0F, total = 0.0F;
  for (int i = 0; i < octaves; ++i) {
    sum += weight * tiled_noise(x, y, period, seed + static_cast<std::uint32_t>(i) * 0x51ED27U);
    total += weight;
    x *= 2.0F, y *= 2.0F, period *= 2, weight *= 0.5F;
  }
  return sum / total;
}

}  // namespace hindsight
