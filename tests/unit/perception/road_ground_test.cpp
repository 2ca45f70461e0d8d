// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_ground.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mounted_camera.h"
#include "perception/road_horizon.h"

namespace hindsight {
namespace {

/// As a camera sees a road on the ground whose middle lies at y = aside + bend x^2, `up_px` higher than it
/// should.
RoadEstimate seen(const CameraModel& camera, double aside_m, double bend_per_m, double width_m,
                  double up_px) {
  RoadEstimate road;
  road.status = RoadStatus::following;
  road.horizon_row_px = horizon_row_px(camera) - up_px;
  for (double x_m = 2.0; x_m <= 12.0; x_m += 1.0) {
    const double y_m = aside_m + bend_per_m * x_m * x_m;
    const auto left = camera.project({x_m, y_m + width_m / 2, 0.0}),
               right = camera.project({x_m, y_m - width_m / 2, 0.0});
    road.row[static_cast<std::size_t>(road.count++)] = {static_cast<float>(left->y_px - up_px),
                                                        static_cast<float>(left->x_px),
                                                        static_cast<float>(right->x_px)};
  }
  return road;
}

TEST(RoadOnGround, IsWhereTheRoadLies) {
  const CameraModel model = mounted_camera();
  for (const double up_px : {0.0, 12.0}) {  // however the vehicle pitches
    const RoadOnGround ground = road_on_ground(seen(model, 0.4, 0.01, 3.0, up_px), model, 30.0);
    ASSERT_EQ(ground.count, 11);
    for (const RoadSection& section : ground.sections()) {
      const Point2 middle = section.middle_B();
      EXPECT_NEAR(middle.y_m, 0.4 + 0.01 * middle.x_m * middle.x_m, 0.02);
      EXPECT_NEAR(section.left_B.y_m - section.right_B.y_m, 3.0, 0.02);
    }
  }
}

TEST(RoadOnGround, LeavesOutWhatIsFarOrNotKnown) {
  const CameraModel model = mounted_camera();
  RoadEstimate road = seen(model, 0.0, 0.0, 3.0, 0.0);
  EXPECT_EQ(road_on_ground(road, model, 6.5).count, 5);
  road.horizon_row_px = std::nan("");
  EXPECT_EQ(road_on_ground(road, model, 30.0).count, 0);
}

TEST(PointAhead, LiesOnTheMiddleAtTheDistanceOrAtTheRoadsEnd) {
  const CameraModel model = mounted_camera();
  const RoadOnGround ground = road_on_ground(seen(model, 0.5, 0.0, 3.0, 0.0), model, 30.0);
  const auto ahead = point_ahead_B(ground, 5.0);
  ASSERT_TRUE(ahead);
  EXPECT_NEAR(std::hypot(ahead->x_m, ahead->y_m), 5.0, 0.02);
  EXPECT_NEAR(ahead->y_m, 0.5, 0.02);
  EXPECT_NEAR(point_ahead_B(ground, 100.0)->x_m, 12.0, 0.1);
  EXPECT_FALSE(point_ahead_B(RoadOnGround{}, 5.0));
}

TEST(Curvature, IsThatOfTheCircleThroughThePoint) {
  EXPECT_NEAR(curvature_to_per_m({2.0, 2.0}), 0.5, 1e-12);  // a quarter of a circle of 2 m
  EXPECT_NEAR(curvature_to_per_m({2.0, -2.0}), -0.5, 1e-12);
  EXPECT_EQ(curvature_to_per_m({3.0, 0.0}), 0.0);
  EXPECT_EQ(curvature_to_per_m({0.0, 0.0}), 0.0);
}

}  // namespace
}  // namespace hindsight
