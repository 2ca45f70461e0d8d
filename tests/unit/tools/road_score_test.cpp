// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/road_score.h"

#include <gtest/gtest.h>

namespace hindsight::tools {
namespace {

/// 10 x 10, road in columns 2 to 5 of all rows but the first.
cv::Mat truth() {
  cv::Mat mask = cv::Mat::zeros(10, 10, CV_8U);
  mask(cv::Rect(2, 1, 4, 9)).setTo(1);
  return mask;
}

TEST(RoadScore, AllOfTheRoadAndNothingElseIsOne) {
  const auto score = score_road(truth(), truth() * 255);
  ASSERT_TRUE(score);
  EXPECT_EQ(score->pixel_coverage, 1.0);
  for (const double line : score->line_coverage) EXPECT_EQ(line, 1.0);
  EXPECT_FALSE(score->failed);
}

TEST(RoadScore, WrongPixelsCountAgainstRightOnes) {
  cv::Mat called = cv::Mat::zeros(10, 10, CV_8U);
  called(cv::Rect(4, 0, 4, 10)).setTo(1);  // of each row of the road 2 right, 2 wrong; 4 wrong above it
  const auto score = score_road(truth(), called);
  ASSERT_TRUE(score);
  EXPECT_NEAR(score->pixel_coverage, (18.0 - 22.0) / 36.0, 1e-12);
  for (const double line : score->line_coverage) EXPECT_EQ(line, 0.0);
}

TEST(RoadScore, IgnoredPixelsDoNotCount) {
  cv::Mat mask = truth();
  mask.col(7).setTo(2);
  cv::Mat called = truth();
  called.col(7).setTo(1);
  EXPECT_EQ(score_road(mask, called)->pixel_coverage, 1.0);
}

TEST(RoadScore, LinesGoFromNearToFar) {
  cv::Mat called = truth();
  called.rowRange(0, 5).setTo(0);
  const auto score = score_road(truth(), called);
  EXPECT_EQ(score->line_coverage.front(), 1.0);
  EXPECT_EQ(score->line_coverage.back(), 0.0);
}

TEST(RoadScore, AFailureIsAFrameWithoutAnyOverlap) {
  RoadScore all;
  cv::Mat beside = cv::Mat::zeros(10, 10, CV_8U);
  beside.col(8).setTo(1);
  all.add(*score_road(truth(), truth()));
  EXPECT_EQ(all.mttf_frames(100.0), 100.0);
  all.add(*score_road(truth(), beside));
  EXPECT_EQ(all.failures, 1);
  all.add(*score_road(truth(), cv::Mat::zeros(10, 10, CV_8U)));
  EXPECT_EQ(all.failures, 2);
  EXPECT_EQ(all.mttf_frames(100.0), 50.0);
  EXPECT_NEAR(all.pixel_coverage, (1.0 - 10.0 / 36.0 + 0.0) / 3.0, 1e-12);
}

TEST(RoadScore, NoRoadNoScore) {
  EXPECT_FALSE(score_road(cv::Mat::zeros(4, 4, CV_8U), cv::Mat::ones(4, 4, CV_8U)));
}

}  // namespace
}  // namespace hindsight::tools
