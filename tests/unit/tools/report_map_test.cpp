// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tools/report_style.h"

namespace hindsight::tools {
namespace {

EvidenceGridParams small_grid() {
  EvidenceGridParams params;
  params.size_cells = 200;
  params.margin_m = 5.0;
  return params;
}

/// Mean place of the pixels of one colour.
cv::Point2d middle_of(const cv::Mat& picture, Rgb color) {
  cv::Point2d sum;
  int found = 0;
  for (int row = 0; row < picture.rows; ++row) {
    for (int column = 0; column < picture.cols; ++column) {
      if (picture.at<cv::Vec3b>(row, column) != color.pixel()) continue;
      sum += cv::Point2d(column, row);
      ++found;
    }
  }
  EXPECT_GT(found, 0);
  return sum / std::max(found, 1);
}

class ReportMap : public testing::Test {
 protected:
  ReportMap() {
    grid.recentre(scene.X_WB);
    scene.grid = &grid;
  }
  void mark(double east_m, double north_m, CellCost cost) {
    grid.mark(grid.window().cell_at(east_m, north_m), cost, EvidenceGrid::kForever);
  }

  EvidenceGrid grid{small_grid()};
  MapScene scene;
};

TEST_F(ReportMap, ShowsNorthUpAndEastRight) {
  mark(4.1, 3.1, CellCost::lethal);
  const MapView view({-5.0, -5.0}, {5.0, 5.0}, 40.0);
  const cv::Mat picture = draw_map(scene, view);
  EXPECT_EQ(picture.size(), cv::Size(400, 400));
  const cv::Point2d lethal = middle_of(picture, kLethal);
  EXPECT_NEAR(lethal.x, (4.1 + 5.0) * 40.0, 1.0);
  EXPECT_NEAR(lethal.y, (5.0 - 3.1) * 40.0, 1.0);
}

TEST_F(ReportMap, DrawsTheBodyBehindAnAxleThatHeadsNorth) {
  scene.X_WB = {0.0, 0.0, M_PI / 2};
  const cv::Point2d body = middle_of(draw_map(scene, MapView({-5.0, -5.0}, {5.0, 5.0}, 40.0)), kLeft);
  EXPECT_NEAR(body.x, 200.0, 2.0);
  EXPECT_GT(body.y, 202.0);  // the tail is longer than the nose, hence to the south
}

TEST_F(ReportMap, DrawsWhereThingsMoveAndWhereTo) {
  ActivityMap activity({.cell = 0.5, .cells = 32, .max_speed = 1.5});
  for (int i = 0; i < 20; ++i) activity.add({2.25, 3.25}, {0.0, 0.1});
  const MapView view({-5.0, -5.0}, {5.0, 5.0}, 40.0);
  const cv::Mat without = draw_map(scene, view);
  scene.activity = &activity;
  cv::Mat changed;
  cv::absdiff(without, draw_map(scene, view), changed);
  cv::cvtColor(changed, changed, cv::COLOR_BGR2GRAY);
  const cv::Rect arrow = cv::boundingRect(changed);
  EXPECT_NEAR(arrow.x + arrow.width / 2.0, (2.25 + 5.0) * 40.0, 2.0);
  EXPECT_NEAR(arrow.br().y, (5.0 - 3.25) * 40.0, 4.0) << "it begins in the cell";
  EXPECT_GT(arrow.height, 20) << "and points north";
}

TEST_F(ReportMap, FitsEverythingThatIsKnown) {
  mark(15.0, -12.0, CellCost::high);
  scene.track_W = {{0.0, 0.0}, {-17.0, 2.0}};
  const MapView view = fit_map(scene, 1000);
  const cv::Rect inside({}, view.size());
  EXPECT_TRUE(inside.contains(view.at({15.0, -12.0})));
  EXPECT_TRUE(inside.contains(view.at({-17.0, 2.0})));
  EXPECT_LE(std::abs(std::max(inside.width, inside.height) - 1000), 1);
}

TEST_F(ReportMap, LeavesOutAGoalFarAway) {
  scene.goal_W = Point2{5000.0, 0.0};
  EXPECT_GT(fit_map(scene, 1000).px_per_m(), 10.0);
}

}  // namespace
}  // namespace hindsight::tools
