// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_line_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hindsight {
namespace {

constexpr float kHalf_px = 50.0F;

/// A row seen often in one place: middle 200, half width 50.
RoadLineFilter settled() {
  RoadLineFilter filter(1);
  for (int i = 0; i < 50; ++i) {
    filter.predict(0.0F, 0.05F);
    filter.correct(0, 200.0F, kHalf_px, kHalf_px, 0.15F);
  }
  return filter;
}

TEST(RoadLineFilter, TakesTheFirstMeasurementAsItIs) {
  RoadLineFilter filter(2);
  EXPECT_FALSE(filter.known(1));
  filter.correct(1, 120.0F, 60.0F, kHalf_px, 0.3F);
  EXPECT_TRUE(filter.known(1));
  EXPECT_FLOAT_EQ(filter.middle_px(1), 120.0F);
  EXPECT_FLOAT_EQ(filter.width_ratio(1), 1.2F);
}

TEST(RoadLineFilter, AveragesNoiseAndFollowsARoadThatMovesAside) {
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0.0F, 0.15F * kHalf_px);
  RoadLineFilter filter(1);
  float middle = 200.0F, squares = 0.0F;
  for (int i = 0; i < 200; ++i) {
    middle += 0.5F;
    filter.predict(0.0F, 0.05F);
    filter.correct(0, middle + noise(random), kHalf_px, kHalf_px, 0.15F);
    if (i >= 50) squares += std::pow(filter.middle_px(0) - middle, 2.0F);
  }
  EXPECT_LT(std::sqrt(squares / 150.0F), 0.7F * 0.15F * kHalf_px) << "less than one measurement's";
}

TEST(RoadLineFilter, MovesARowWithTheCamerasTurn) {
  RoadLineFilter filter = settled();
  filter.predict(12.0F, 0.0F);
  EXPECT_NEAR(filter.middle_px(0), 212.0F, 1e-3F);
}

TEST(RoadLineFilter, IsHardlyWidenedByTheMouthOfASideRoad) {
  RoadLineFilter filter = settled();
  for (int i = 0; i < 3; ++i) {  // the left edge is seen a whole road's width farther out, for three frames
    filter.predict(0.0F, 0.05F);
    filter.correct(0, 150.0F, 2.0F * kHalf_px, kHalf_px, 0.15F);
  }
  const float left_px = filter.middle_px(0) - filter.width_ratio(0) * kHalf_px;
  const float right_px = filter.middle_px(0) + filter.width_ratio(0) * kHalf_px;
  EXPECT_GT(left_px, 150.0F - 0.3F * kHalf_px);
  EXPECT_NEAR(right_px, 250.0F, 1e-3F) << "the other edge stays";
}

TEST(RoadLineFilter, WidthsStayAboveZeroWhateverIsMeasured) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> middle(0.0F, 400.0F), half(0.5F, 200.0F);
  RoadLineFilter filter(1);
  for (int i = 0; i < 10'000; ++i) {
    filter.predict(0.0F, 0.3F);
    filter.correct(0, middle(random), half(random), kHalf_px, 0.15F);
    ASSERT_GT(filter.width_ratio(0), 0.0F) << i;
  }
}

}  // namespace
}  // namespace hindsight
