// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/horizon_line.h"

#include <gtest/gtest.h>

#include <random>

namespace hindsight {
namespace {

constexpr int kWidth = 360, kHeight = 240;

std::vector<std::uint8_t> landscape(double middle_row, double tan_angle, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::uint8_t> bgr;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool sky = y < middle_row + tan_angle * (x - (kWidth - 1) / 2.0);
      const auto noise = static_cast<int>(random() % 41) - 20;
      bgr.push_back(static_cast<std::uint8_t>((sky ? 220 : 90) + noise));
      bgr.push_back(128);
      bgr.push_back(128);
    }
  }
  return bgr;
}

TEST(HorizonFinder, FindsTiltedHorizons) {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    std::mt19937 random(seed);
    const double row = std::uniform_real_distribution(50.0, 180.0)(random);
    const double tan_angle = std::uniform_real_distribution(-0.2, 0.2)(random);
    const std::vector<std::uint8_t> bgr = landscape(row, tan_angle, seed);
    HorizonFinder finder(kWidth, kHeight);
    const HorizonLine line = finder.find({bgr, kWidth, kHeight});
    EXPECT_NEAR(line.middle_row_px, row, 6.0) << "seed " << seed;
    EXPECT_NEAR(line.tan_angle, tan_angle, 0.04) << "seed " << seed;
    EXPECT_GT(line.explained, 0.5F) << "seed " << seed;
  }
}

TEST(HorizonFinder, ExplainsNothingWhereThereIsNoSky) {
  const std::vector<std::uint8_t> bgr = landscape(-100.0, 0.0, 7);
  HorizonFinder finder(kWidth, kHeight);
  EXPECT_LT(finder.find({bgr, kWidth, kHeight}).explained, 0.2F);
  const std::vector<std::uint8_t> black(3 * kWidth * kHeight, 0);
  EXPECT_EQ(finder.find({black, kWidth, kHeight}).explained, 0.0F);
}

}  // namespace
}  // namespace hindsight
