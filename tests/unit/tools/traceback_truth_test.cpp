// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/traceback_truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hindsight::tools {
namespace {

constexpr int kWidth_px = 101, kHeight_px = 81;
constexpr double kFocal_px = 50.0, kWall_m = 12.0;

CameraModel level_camera() {
  CameraModel camera;
  camera.width_px = kWidth_px;
  camera.height_px = kHeight_px;
  camera.fx_px = camera.fy_px = kFocal_px;
  camera.cx_px = 50.0;
  camera.cy_px = 40.0;
  camera.p_BC_m = {0.2, 0.0, 1.0};
  camera.set_orientation(0.0, 0.0, 0.0);
  camera.set_field_of_view();
  return camera;
}

/// Everything in view is at one depth: a wall across the way, seen at right angles.
std::vector<float> wall(double depth_m) {
  return std::vector<float>(static_cast<std::size_t>(kWidth_px * kHeight_px), static_cast<float>(depth_m));
}

/// Drives straight at the wall, 0.5 m a frame, 1 + `frames` frames.
TracebackTruth drive_at_wall(int frames, int every) {
  TracebackTruth truth(level_camera(), 10, every);
  for (int i = 0; i <= frames; ++i) truth.push({.x_m = 0.5 * i}, wall(kWall_m - 0.5 * i));
  return truth;
}

TEST(TracebackTruthTest, APointOfAWallAheadRunsTowardsTheMiddleBackwardsInTime) {
  const auto place = drive_at_wall(8, 1).place_of(70, 50, 8);
  ASSERT_TRUE(place.has_value());
  // 8 m away now, 12 m then.
  EXPECT_NEAR(place->px.x_px, 50.0 + 20.0 * 8.0 / 12.0, 1e-4);
  EXPECT_NEAR(place->px.y_px, 40.0 + 10.0 * 8.0 / 12.0, 1e-4);
  EXPECT_NEAR(place->distance_m, std::sqrt(12.0 * 12.0 + 3.2 * 3.2 + 1.6 * 1.6), 1e-4);
  EXPECT_FALSE(place->left_view);
}

TEST(TracebackTruthTest, KnowsNoMoreThanItRemembers) {
  EXPECT_EQ(drive_at_wall(8, 1).size(), 8);
  EXPECT_FALSE(drive_at_wall(8, 1).place_of(50, 40, 9).has_value());
  EXPECT_EQ(drive_at_wall(14, 1).size(), 10);
  EXPECT_FALSE(drive_at_wall(14, 1).place_of(50, 40, 11).has_value());
  EXPECT_FALSE(drive_at_wall(8, 4).place_of(50, 40, 3).has_value());
  EXPECT_TRUE(drive_at_wall(8, 4).place_of(50, 40, 4).has_value());
}

TEST(TracebackTruthTest, SkyAndWhatWasHiddenHaveNoPlace) {
  TracebackTruth truth(level_camera(), 5, 1);
  truth.push({}, wall(3.0));  // something stood in front of the wall
  truth.push({}, wall(kWall_m));
  EXPECT_FALSE(truth.place_of(50, 40, 1).has_value());
  truth.push({}, wall(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(truth.place_of(50, 40, 1).has_value());
}

TEST(TracebackTruthTest, TellsWhatLeftTheViewInBetween) {
  TracebackTruth truth(level_camera(), 5, 1);
  truth.push({}, wall(kWall_m));
  truth.push({.heading_rad = 1.5}, wall(kWall_m));
  truth.push({}, wall(kWall_m));
  const auto place = truth.place_of(50, 40, 2);
  ASSERT_TRUE(place.has_value());
  EXPECT_TRUE(place->left_view);
  EXPECT_NEAR(place->px.x_px, 50.0, 1e-6);
}

}  // namespace
}  // namespace hindsight::tools
