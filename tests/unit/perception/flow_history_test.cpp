// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/flow_history.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hindsight {
namespace {

constexpr int kWidth = 720, kHeight = 480;

FlowHistoryParams thesis() {
  FlowHistoryParams params;
  params.columns = 12;
  params.rows = 8;
  params.max_vector_px = 60.0;
  params.statistic = "mean";
  params.fill = "zero";
  params.lookup = "cell";
  return params;
}

/// A vector every 8 pixels, from where a point is to where it was.
std::vector<FlowVector> dense(auto&& where_before) {
  std::vector<FlowVector> flow;
  for (float y = 4.0F; y < kHeight; y += 8.0F) {
    for (float x = 4.0F; x < kWidth; x += 8.0F) {
      const Point2f before = where_before(Point2f{x, y});
      flow.push_back({x, y, before.x_px - x, before.y_px - y});
    }
  }
  return flow;
}

auto constant(float dx, float dy) {
  return dense([=](Point2f p) { return Point2f{p.x_px + dx, p.y_px + dy}; });
}

TEST(FlowHistory, FollowsConstantFlowExactly) {
  for (const FlowHistoryParams& params : {thesis(), FlowHistoryParams{}}) {
    FlowHistory history(params, kWidth, kHeight);
    for (int i = 0; i < 50; ++i) history.push(constant(-2.0F, -1.0F));
    const auto trace = history.trace_back({400.0F, 300.0F}, 40);
    EXPECT_EQ(trace.frames_back, 40);
    EXPECT_FALSE(trace.entered_here);
    EXPECT_NEAR(trace.point_px.x_px, 320.0F, 0.01F);
    EXPECT_NEAR(trace.point_px.y_px, 260.0F, 0.01F);
  }
}

TEST(FlowHistory, FollowsRotationAndExpansion) {
  const Point2f centre{360.0F, 200.0F};
  for (const auto& [scale, angle_rad] : {std::pair{1.0F, 0.01F}, {0.97F, 0.0F}, {0.99F, -0.005F}}) {
    const auto before = [&, scale = scale, angle_rad = angle_rad](Point2f p) {
      const float x = p.x_px - centre.x_px, y = p.y_px - centre.y_px;
      const float c = scale * std::cos(angle_rad), s = scale * std::sin(angle_rad);
      return Point2f{centre.x_px + c * x - s * y, centre.y_px + s * x + c * y};
    };
    FlowHistory history({}, kWidth, kHeight);
    for (int i = 0; i < 60; ++i) history.push(dense(before));
    Point2f expected{450.0F, 350.0F};
    for (int i = 0; i < 60; ++i) expected = before(expected);
    const auto trace = history.trace_back({450.0F, 350.0F}, 60);
    EXPECT_EQ(trace.frames_back, 60);
    EXPECT_LT(std::hypot(trace.point_px.x_px - expected.x_px, trace.point_px.y_px - expected.y_px), 2.0F)
        << scale << ", " << angle_rad;
  }
}

TEST(FlowHistory, StopsWhereThePointEnteredTheView) {
  FlowHistory history({}, kWidth, kHeight);
  for (int i = 0; i < 50; ++i) history.push(constant(10.0F, 0.0F));
  const auto trace = history.trace_back({685.0F, 100.0F}, 50);
  EXPECT_TRUE(trace.entered_here);
  EXPECT_EQ(trace.frames_back, 3);
  EXPECT_NEAR(trace.point_px.x_px, 715.0F, 0.01F);
  EXPECT_TRUE(history.trace_back({685.0F, 100.0F}, 3).entered_here);
  EXPECT_FALSE(history.trace_back({685.0F, 100.0F}, 2).entered_here);
}

TEST(FlowHistory, StopsAtTheOldestFrameAndWrapsAround) {
  FlowHistory history({}, kWidth, kHeight);
  for (int i = 0; i < 137; ++i) history.push(constant(50.0F, 50.0F));  // all of it overwritten below
  for (int i = 0; i < 200; ++i) history.push(constant(i < 100 ? 1.0F : -0.5F, 0.0F));
  EXPECT_EQ(history.size(), 200);
  const auto trace = history.trace_back({300.0F, 200.0F}, 1000);
  EXPECT_EQ(trace.frames_back, 200);
  EXPECT_FALSE(trace.entered_here);
  EXPECT_NEAR(trace.point_px.x_px, 350.0F, 0.05F);
}

TEST(FlowHistory, TracesFromAnOlderFrame) {
  FlowHistory history({}, kWidth, kHeight);
  for (int i = 0; i < 10; ++i) history.push(constant(-1.0F, 0.0F));
  for (int i = 0; i < 5; ++i) history.push(constant(20.0F, 0.0F));
  const auto trace = history.trace_back({300.0F, 200.0F}, 4, 5);
  EXPECT_EQ(trace.frames_back, 9);
  EXPECT_NEAR(trace.point_px.x_px, 296.0F, 0.01F);
  EXPECT_EQ(history.trace_back({300.0F, 200.0F}, 4, 15).frames_back, 15);
}

TEST(FlowHistory, ClearForgets) {
  FlowHistory history({}, kWidth, kHeight);
  history.push(constant(5.0F, 5.0F));
  history.clear();
  EXPECT_EQ(history.size(), 0);
  const auto trace = history.trace_back({300.0F, 200.0F}, 10);
  EXPECT_EQ(trace.frames_back, 0);
  EXPECT_EQ(trace.point_px.x_px, 300.0F);
}

TEST(FlowHistory, StartOutsideTheImageComesBackAsItIs) {
  FlowHistory history({}, kWidth, kHeight);
  history.push(constant(5.0F, 5.0F));
  for (const Point2f p : {Point2f{-1.0F, 10.0F}, {720.0F, 10.0F}, {10.0F, NAN}}) {
    EXPECT_EQ(history.trace_back(p, 10).frames_back, 0);
  }
}

TEST(FlowHistory, ThesisGridIsTheMeanWithoutLongVectorsAndZeroWhereEmpty) {
  FlowHistory history(thesis(), kWidth, kHeight);
  const std::vector<FlowVector> flow = {{10.0F, 10.0F, 1.0F, 4.0F},
                                        {20.0F, 50.0F, 3.0F, 0.0F},
                                        {30.0F, 30.0F, 61.0F, 0.0F},
                                        {70.0F, 10.0F, 60.0F, 0.0F}};
  history.push(flow);
  const FlowGrid& grid = history.newest();
  EXPECT_EQ(grid.at(0, 0).count, 2);
  EXPECT_EQ(grid.at(0, 0).dx_px, 2.0F);
  EXPECT_EQ(grid.at(0, 0).dy_px, 2.0F);
  EXPECT_EQ(grid.at(1, 0).dx_px, 60.0F);
  EXPECT_EQ(grid.at(5, 5).count, 0);
  EXPECT_EQ(grid.at(5, 5).dx_px, 0.0F);
}

TEST(FlowHistory, MedianIgnoresAnOutlier) {
  FlowHistory history({}, kWidth, kHeight);
  const std::vector<FlowVector> flow = {{2.0F, 2.0F, 1.0F, 1.0F},
                                        {3.0F, 3.0F, 2.0F, 2.0F},
                                        {4.0F, 4.0F, 90.0F, -9.0F},
                                        {5.0F, 5.0F, 3.0F, 1.0F}};
  history.push(flow);
  EXPECT_EQ(history.newest().at(0, 0).dx_px, 2.5F);
  EXPECT_EQ(history.newest().at(0, 0).dy_px, 1.0F);
}

TEST(FlowHistory, NeighboursFillEveryEmptyCell) {
  FlowHistory history({}, kWidth, kHeight);
  const std::vector<FlowVector> flow = {{100.0F, 100.0F, 4.0F, -2.0F}};
  history.push(flow);
  for (const FlowCell& cell : history.newest().cells) EXPECT_EQ(cell.dx_px, 4.0F);
  history.push({});
  for (const FlowCell& cell : history.newest().cells) EXPECT_EQ(cell.dx_px, 0.0F);
  EXPECT_EQ(history.size(), 2);
}

}  // namespace
}  // namespace hindsight
