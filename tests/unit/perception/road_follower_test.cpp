// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_follower.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "config/exit_code.h"

namespace hindsight {
namespace {

constexpr int kWidth = 240, kHeight = 160;
constexpr double kHorizon = 40.0;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A camera one metre above flat ground that drives along a road of soil between gravel: pictures and the
/// flow between them, both made from where things are.
class Drive {
 public:
  explicit Drive(const RoadParams& params, double horizon_px = kHorizon)
      : history_(FlowHistoryParams{.columns = 24, .rows = 16, .depth = 60}, kWidth, kHeight),
        appearance_(AppearanceHistoryParams{.shrink = 1}, 61, kWidth, kHeight),
        follower_(params, {kWidth, kHeight, 1, horizon_px}, 60),
        bgr_(3 * kWidth * kHeight) {}

  double aside_m = 0.0;  ///< the road's middle, left of the vehicle
  double half_width_m = 1.5;
  bool road = true;
  double light = 1.0;
  double rise_px = 0.0;  ///< how far a slope ahead reaches above the horizon of flat ground

  const RoadEstimate& frame() {
    paint();
    std::vector<FlowVector> flow;
    for (int y = 45; y < kHeight; y += 5)
      for (int x = 5; x < kWidth; x += 9)
        flow.push_back(flow_at(static_cast<float>(x), static_cast<float>(y)));
    for (int x = 5; x < kWidth; x += 9) flow.push_back({static_cast<float>(x), 38.0F, 0.0F, 0.0F});
    if (frames_ > 0) history_.push(flow);
    appearance_.push(bgr_);
    ++frames_;
    return follower_.update({flow, history_, appearance_, 0.1});
  }
  const RoadEstimate& frames(int count) {
    for (int i = 1; i < count; ++i) frame();
    return frame();
  }
  /// Column of the road's edge in a row; side -1: left.
  double edge(double row, int side) const {
    const double below = rise_px > 0.0 ? std::max(row - kHorizon, kSlopeFrom) : row - kHorizon;
    return kWidth / 2.0 + (-aside_m + side * half_width_m) * below;
  }

 private:
  static constexpr double kStep_m = 0.1;
  static constexpr double kSlopeFrom = 12.0;  ///< rows below the horizon where the slope begins

  /// Depth 1 m times focal length over rows below the horizon; one step back it was a little farther.
  FlowVector flow_at(float x, float y) const {
    const double below = y - kHorizon, depth = 100.0 / below;
    const double then = 100.0 / (depth + kStep_m);
    return {x, y, static_cast<float>((x - kWidth / 2.0) * (then / below - 1.0)),
            static_cast<float>(then - below)};
  }
  void paint() {
    std::uniform_real_distribution<double> noise(-12.0, 12.0);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const bool sky = y < kHorizon - rise_px, on = road && x > edge(y, -1) && x < edge(y, 1);
        const double n = noise(random_);
        const double b = sky  ? 230.0
                         : on ? 70.0
                              : 110.0,
                     g = sky  ? 200.0
                         : on ? 105.0
                              : 118.0,
                     r = sky  ? 180.0
                         : on ? 140.0
                              : 120.0;
        std::uint8_t* p = &bgr_[static_cast<std::size_t>(3 * (y * kWidth + x))];
        const double values[] = {b, g, r};
        for (int k = 0; k < 3; ++k)
          p[k] = static_cast<std::uint8_t>(std::clamp(light * (values[k] + n), 0.0, 255.0));
      }
    }
  }

  FlowHistory history_;
  AppearanceHistory appearance_;
  RoadFollower follower_;
  std::vector<std::uint8_t> bgr_;
  std::mt19937 random_{42};
  int frames_ = 0;
};

RoadParams quick() {
  RoadParams params;
  params.min_history_s = 1.0;
  return params;
}

RoadParams thesis() {
  RoadParams params = quick();
  params.method = "templates";
  params.definition_width = 0.8;
  params.definition_bottom = 0.75;
  params.definition_height_px = 8;
  return params;
}

void expect_road(const RoadEstimate& estimate, const Drive& drive, double tolerance,
                 double lowest_row = kHeight) {
  ASSERT_EQ(estimate.status, RoadStatus::following);
  ASSERT_GE(estimate.count, 6);
  for (const RoadRow& row : estimate.rows()) {
    if (row.row_px < kHorizon + 12.0 || row.row_px > lowest_row) continue;
    const double half = 0.5 * (drive.edge(row.row_px, 1) - drive.edge(row.row_px, -1));
    EXPECT_NEAR(row.left_px, drive.edge(row.row_px, -1), tolerance * half) << row.row_px;
    EXPECT_NEAR(row.right_px, drive.edge(row.row_px, 1), tolerance * half) << row.row_px;
  }
}

TEST(RoadFollower, SaysNothingBeforeItHasSeenEnough) {
  RoadParams params;
  params.min_history_s = 2.0;
  Drive drive(params);
  EXPECT_EQ(drive.frames(19).status, RoadStatus::short_history);
  EXPECT_EQ(drive.frame().status, RoadStatus::following);
}

TEST(RoadFollower, FindsAStraightRoad) {
  Drive drive(quick());
  drive.aside_m = 0.3;
  expect_road(drive.frames(40), drive, 0.15);
}

TEST(RoadFollower, FollowsTheRoadUpASlopeAboveTheHorizon) {
  Drive drive(quick());
  drive.rise_px = 20.0;
  const RoadEstimate& estimate = drive.frames(60);
  ASSERT_EQ(estimate.status, RoadStatus::following);
  EXPECT_LT(estimate.rows().back().row_px, kHorizon - 14.0);
  for (const RoadRow& row : estimate.rows()) {
    if (row.row_px < kHorizon - 16.0) continue;
    const double half = 0.5 * (drive.edge(row.row_px, 1) - drive.edge(row.row_px, -1));
    EXPECT_NEAR(row.left_px, drive.edge(row.row_px, -1), 0.25 * half) << row.row_px;
    EXPECT_NEAR(row.right_px, drive.edge(row.row_px, 1), 0.25 * half) << row.row_px;
  }
}

TEST(RoadFollower, TellsNothingAboveTheHorizonOfFlatGround) {
  Drive drive(quick());
  EXPECT_GT(drive.frames(60).rows().back().row_px, kHorizon - 6.0);
}

TEST(RoadFollower, FindsTheHorizonOfAnUnknownCamera) {
  Drive drive(quick(), kNan);
  const RoadEstimate& estimate = drive.frames(60);
  expect_road(estimate, drive, 0.2);
  EXPECT_NEAR(estimate.horizon_row_px, kHorizon, 8.0);
}

TEST(RoadFollower, FollowsARoadThatMovesAside) {
  Drive drive(quick());
  drive.frames(30);
  for (int i = 0; i < 30; ++i) {
    drive.aside_m += 0.02;
    drive.frame();
  }
  expect_road(drive.frames(5), drive, 0.2);
}

TEST(RoadFollower, DoesNotMindTheLight) {
  Drive drive(quick());
  drive.frames(30);
  for (int i = 0; i < 20; ++i) {
    drive.light -= 0.02;
    drive.frame();
  }
  expect_road(drive.frames(10), drive, 0.2);
}

TEST(RoadFollower, SaysWhereThereIsNoneAndFindsItAgain) {
  Drive drive(quick());
  drive.frames(30);
  drive.road = false;
  const RoadEstimate& lost = drive.frames(200);
  EXPECT_EQ(lost.status, RoadStatus::no_road);
  EXPECT_EQ(lost.count, 0);
  drive.road = true;
  expect_road(drive.frames(100), drive, 0.2);
}

TEST(RoadFollower, TheThesisMethodFindsAStraightRoad) {
  Drive drive(thesis());
  // Below the strip that it goes by, it takes the road to be no wider.
  expect_road(drive.frames(60), drive, 0.35, 120.0);
}

TEST(RoadFollower, TheThesisMethodSaysThatThereIsNoHorizon) {
  Drive drive(thesis());
  drive.frames(40);
  drive.light = 0.0;
  EXPECT_TRUE(std::isnan(drive.frame().horizon_row_px));
}

TEST(RoadFollower, SaysThatACameraLooksAboveTheGround) {
  Drive drive(quick(), 155.0);
  const RoadEstimate& estimate = drive.frames(40);
  EXPECT_EQ(estimate.status, RoadStatus::no_horizon);
  EXPECT_EQ(estimate.count, 0);
}

TEST(RoadFollower, RefusesADefinitionRegionOutsideThePicture) {
  RoadParams params;
  params.definition_centre = 0.02;
  try {
    RoadFollower follower(params, {kWidth, kHeight, 1, kHorizon}, 60);
    FAIL();
  } catch (const FatalError& error) {
    EXPECT_EQ(error.code(), kExitConfiguration);
    EXPECT_NE(std::string(error.what()).find("definition region"), std::string::npos);
  }
}

TEST(RoadFollower, ForgetsWhenTheFramesAreInterrupted) {
  Drive drive(quick());
  EXPECT_EQ(drive.frames(30).status, RoadStatus::following);
  RoadFollower follower(quick(), {kWidth, kHeight, 1, kHorizon}, 60);
  follower.reset();
  EXPECT_EQ(follower.estimate().status, RoadStatus::short_history);
}

TEST(RoadFollower, TheSameFramesGiveTheSameRoad) {
  Drive one(quick()), other(quick());
  const RoadEstimate& a = one.frames(35);
  const RoadEstimate& b = other.frames(35);
  ASSERT_EQ(a.count, b.count);
  for (int i = 0; i < a.count; ++i)
    EXPECT_EQ(a.rows()[static_cast<std::size_t>(i)].left_px, b.rows()[static_cast<std::size_t>(i)].left_px);
}

}  // namespace
}  // namespace hindsight
