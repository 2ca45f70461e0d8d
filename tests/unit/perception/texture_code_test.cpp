// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/texture_code.h"

#include <gtest/gtest.h>

#include <random>

namespace hindsight {
namespace {

std::vector<std::uint8_t> picture(int width, int height, auto&& grey) {
  std::vector<std::uint8_t> bgr;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) bgr.insert(bgr.end(), 3, static_cast<std::uint8_t>(grey(x, y)));
  return bgr;
}

int across(int code) { return code / kTextureLevels; }
int down(int code) { return code % kTextureLevels; }

TEST(TextureCode, OfFlatGreyIsZero) {
  const auto bgr = picture(9, 9, [](int, int) { return 77; });
  EXPECT_EQ(texture_code_at(bgr, 9, 9, 4, 4), 0);
  EXPECT_EQ(texture_code_at(bgr, 9, 9, 0, 8), 0);
}

TEST(TextureCode, LevelsAreHalfOctavesOfTheMeanDifference) {
  const int expected[] = {0, 1, 2, 2, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 6, 7, 7, 7};
  for (int difference = 0; difference < 24; ++difference) {
    const auto ridges = picture(9, 9, [&](int x, int) { return x % 2 * difference; });
    const int code = texture_code_at(ridges, 9, 9, 4, 4);
    EXPECT_EQ(across(code), expected[difference]) << difference;
    EXPECT_EQ(down(code), 0) << "upright ridges change across alone";
    const auto layers = picture(9, 9, [&](int, int y) { return y % 2 * difference; });
    EXPECT_EQ(texture_code_at(layers, 9, 9, 4, 4), expected[difference]) << "lying ones down alone";
  }
}

TEST(TextureMap, EqualsThePixelsOneByOne) {
  std::mt19937 random(1);
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {17, 9}, {64, 33}, {121, 40}}) {
    TextureMap map(width, height);
    for (const int contrast : {4, 40, 255}) {
      std::vector<std::uint8_t> bgr(static_cast<std::size_t>(3 * width * height));
      for (std::uint8_t& v : bgr) v = static_cast<std::uint8_t>(random() % static_cast<unsigned>(contrast));
      const auto codes = map.update(bgr);
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          ASSERT_EQ(codes[static_cast<std::size_t>(y * width + x)], texture_code_at(bgr, width, height, x, y))
              << width << 'x' << height << " at " << x << ' ' << y;
    }
  }
}

}  // namespace
}  // namespace hindsight
