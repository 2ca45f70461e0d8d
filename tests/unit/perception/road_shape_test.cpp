// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_shape.h"

#include <gtest/gtest.h>

#include <vector>

namespace hindsight {
namespace {

constexpr int kWidth_px = 360, kHeight_px = 240;

class RoadShapeTest : public testing::Test {
 protected:
  RoadShapeTest() {
    lay_road_rows(shape_, kHeight_px, rows_);
    for (const SearchRow& row : rows_) roads_.push_back({180.0F, shape_.half_width_px(row.row), 1.0F, 1.0F});
  }
  const RoadShape shape_{80.0F, 0.8F};
  std::vector<SearchRow> rows_ = std::vector<SearchRow>(24);
  std::vector<FoundRoad> roads_;
};

TEST_F(RoadShapeTest, RowsGoUpEvenlyToJustAboveTheHorizon) {
  EXPECT_FLOAT_EQ(rows_.front().row, kHeight_px - 1.0F);
  EXPECT_LT(rows_.back().row, shape_.horizon);
  for (std::size_t k = 1; k < rows_.size(); ++k) {
    EXPECT_NEAR(rows_[k - 1].row - rows_[k].row, rows_[0].row - rows_[1].row, 1e-3);
    EXPECT_LT(rows_[k].top, rows_[k].bottom);
  }
}

TEST_F(RoadShapeTest, WidthsTellSlopeAndHorizon) {
  const auto fit = fit_road_shape(std::span(rows_).first(18), std::span(roads_).first(18), kWidth_px);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slope, shape_.slope, 1e-3);
  EXPECT_NEAR(fit->horizon, shape_.horizon, 0.1);
}

TEST_F(RoadShapeTest, RowsThatReachOverTheBorderOrFitBadlySayNothing) {
  for (std::size_t k = 0; k < 4; ++k) roads_[k].middle_px = 20.0F, roads_[k].half_width_px *= 3.0F;
  roads_[5].half_width_px *= 2.0F, roads_[5].fit = 0.1F;
  const auto fit = fit_road_shape(std::span(rows_).first(18), std::span(roads_).first(18), kWidth_px);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->horizon, shape_.horizon, 0.1);
  EXPECT_FALSE(fit_road_shape(std::span(rows_).first(8), std::span(roads_).first(8), kWidth_px))
      << "three rows are too few";
}

TEST_F(RoadShapeTest, ARoadGoesOnStraight) {
  std::vector<ExpectedRoad> expected(rows_.size());
  for (std::size_t k = 0; k < kStraightRows; ++k) expected[k].middle_px = 100.0F + 0.5F * rows_[k].row;
  EXPECT_NEAR(straight_on(rows_, expected, kStraightRows), 100.0F + 0.5F * rows_[kStraightRows].row, 1e-3);
}

}  // namespace
}  // namespace hindsight
