// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/color_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace hindsight {
namespace {

TEST(ColorSpace, RgbIsTheBytesInTheOrderRedGreenBlue) {
  EXPECT_EQ(color_of(ColorSpace::rgb, 1, 2, 3), Eigen::Vector3d(3.0, 2.0, 1.0));
}

TEST(ColorSpace, LabAgreesWithThePublishedValuesOfThePrimaries) {
  const auto near = [](const Eigen::Vector3d& lab, double l, double a, double b) {
    EXPECT_NEAR(lab[0], l, 0.02);
    EXPECT_NEAR(lab[1], a, 0.05);
    EXPECT_NEAR(lab[2], b, 0.05);
  };
  near(color_of(ColorSpace::lab, 0, 0, 0), 0.0, 0.0, 0.0);
  near(color_of(ColorSpace::lab, 255, 255, 255), 100.0, 0.0, 0.0);
  near(color_of(ColorSpace::lab, 0, 0, 255), 53.24, 80.09, 67.20);
  near(color_of(ColorSpace::lab, 0, 255, 0), 87.73, -86.18, 83.18);
  near(color_of(ColorSpace::lab, 255, 0, 0), 32.30, 79.19, -107.86);
}

TEST(ColorSpace, LabAgreesWithTheFormulasOfTheStandardsInTheCLibrary) {
  const auto linear = [](int v) {
    const double u = v / 255.0;
    return u <= 0.04045 ? u / 12.92 : std::pow((u + 0.055) / 1.055, 2.4);
  };
  for (int v = 0; v < 256; ++v) {  // grey: a* and b* vanish but for the white point's digits
    const double t = linear(v);
    const double f = t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    const auto byte = static_cast<std::uint8_t>(v);
    EXPECT_NEAR(color_of(ColorSpace::lab, byte, byte, byte)[0], 116.0 * f - 16.0, 1e-9) << v;
  }
}

TEST(ColorSpace, FloatsStayWithinTheirBoundForAll2To24Colors) {
  constexpr int kCount = 1 << 12;
  std::vector<std::uint32_t> keys(kCount);
  std::array<std::vector<float>, 3> channels;
  for (auto& c : channels) c.resize(kCount);
  float* const out[3] = {channels[0].data(), channels[1].data(), channels[2].data()};
  for (const ColorSpace space : {ColorSpace::rgb, ColorSpace::lab}) {
    double worst = 0.0;
    for (std::uint32_t begin = 0; begin < 1u << 24; begin += kCount) {
      for (std::uint32_t i = 0; i < kCount; ++i) keys[i] = begin + i;
      colors_of(space, keys.data(), kCount, out);
      for (std::uint32_t i = 0; i < kCount; ++i) {
        const auto byte = [&](unsigned shift) { return static_cast<std::uint8_t>(keys[i] >> shift & 255u); };
        const Eigen::Vector3d exact = color_of(space, byte(0), byte(8), byte(16));
        for (int k = 0; k < 3; ++k)
          worst = std::max(worst, std::fabs(static_cast<double>(out[k][i]) - exact[k]));
      }
    }
    EXPECT_LE(worst, color_float_error(space)) << static_cast<int>(space);
  }
}

TEST(ColorSpace, NamesAreRgbAndLab) {
  EXPECT_EQ(parse_color_space("rgb"), ColorSpace::rgb);
  EXPECT_EQ(parse_color_space("lab"), ColorSpace::lab);
  EXPECT_THROW(parse_color_space("hsv"), std::invalid_argument);
}

}  // namespace
}  // namespace hindsight
