// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/ground_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <vector>

namespace hindsight {
namespace {

CameraModel test_camera(double roll_rad) {
  CameraModel camera;
  camera.width_px = 180;
  camera.height_px = 120;
  camera.fx_px = 105;
  camera.fy_px = 103;
  camera.cx_px = 91;
  camera.cy_px = 58;
  camera.distortion = {-0.2, 0.05, 0.001, -0.0005, 0.0, 0, 0, 0};
  camera.p_BC_m = {0.3, -0.1, 1.2};
  camera.set_orientation(roll_rad, 0.25, 0.1);
  camera.set_field_of_view();
  return camera;
}

/// The plane's equation solved anew, from OpenCV's undistortion.
Point2 by_brute_force(const CameraModel& camera, int x, int y) {
  const cv::Matx33d k(camera.fx_px, 0, camera.cx_px, 0, camera.fy_px, camera.cy_px, 0, 0, 1);
  const std::vector<double> d(camera.distortion.begin(), camera.distortion.end());
  std::vector<cv::Point2d> in{{double(x), double(y)}}, out;
  cv::undistortPoints(in, out, k, d, cv::noArray(), cv::noArray(), cv::TermCriteria(3, 200, 1e-12));
  const Eigen::Vector3d ray = camera.R_BC * Eigen::Vector3d(out[0].x, out[0].y, 1);
  if (ray.z() >= 0) return {NAN, NAN};
  const Eigen::Vector3d p = camera.p_BC_m - ray * (camera.p_BC_m.z() / ray.z());
  return {p.x(), p.y()};
}

TEST(GroundPlane, EqualsRayMeetsPlane) {
  const CameraModel camera = test_camera(0.05);
  const double kMaxRange_m = 30;
  const GroundPlane ground(camera, kMaxRange_m);
  int seen = 0;
  for (int y = 0; y < camera.height_px; ++y) {
    for (int x = 0; x < camera.width_px; ++x) {
      const Point2 expected = by_brute_force(camera, x, y);
      const GroundPoint p = ground.at(x, y);
      const double range_m = std::hypot(expected.x_m, expected.y_m);
      if (!(range_m <= kMaxRange_m)) {
        EXPECT_TRUE(std::isnan(p.x_m) && std::isnan(p.y_m)) << x << ' ' << y << ' ' << range_m;
        continue;
      }
      ++seen;
      EXPECT_NEAR(p.x_m, expected.x_m, 1e-4 * range_m);
      EXPECT_NEAR(p.y_m, expected.y_m, 1e-4 * range_m);
    }
  }
  EXPECT_GT(seen, camera.width_px * camera.height_px / 2);
}

TEST(GroundPlane, GroundProjectsBackToItsPixel) {
  const CameraModel camera = test_camera(-0.08);
  const GroundPlane ground(camera, 10);
  for (int y = 0; y < camera.height_px; y += 3) {
    for (int x = 0; x < camera.width_px; x += 3) {
      const GroundPoint p = ground.at(x, y);
      if (std::isnan(p.x_m)) continue;
      const auto pixel = camera.project({p.x_m, p.y_m, 0});
      ASSERT_TRUE(pixel);
      EXPECT_NEAR(pixel->x_px, x, 1e-3);
      EXPECT_NEAR(pixel->y_px, y, 1e-3);
    }
  }
}

TEST(GroundPlane, LeftInThePictureIsLeftOnTheGround) {
  CameraModel camera = test_camera(0);
  camera.set_orientation(0, 0.25, 0);
  camera.p_BC_m.y() = 0;
  const GroundPlane ground(camera, 30);
  EXPECT_GT(ground.at(10, 110).y_m, 0.2F);
  EXPECT_LT(ground.at(170, 110).y_m, -0.2F);
  EXPECT_LT(ground.at(91, 110).x_m, ground.at(91, 60).x_m) << "higher is farther";
}

TEST(GroundPlane, HorizonDividesGroundFromSky) {
  const CameraModel camera = test_camera(0.1);
  const GroundPlane ground(camera, 1e9);
  for (int x = 0; x < camera.width_px; ++x) {
    const float row = ground.horizon_row_px()[static_cast<std::size_t>(x)];
    EXPECT_TRUE(std::isnan(ground.at(x, static_cast<int>(std::floor(row))).x_m));
    EXPECT_FALSE(std::isnan(ground.at(x, static_cast<int>(std::floor(row)) + 1).x_m));
    EXPECT_NEAR(camera.ray_B({double(x), double(row)}).z(), 0, 2e-4);
  }
  EXPECT_GT(ground.horizon_row_px()[0], ground.horizon_row_px()[179])
      << "right side down: horizon higher on the right";
}

TEST(GroundPlane, HorizonOutOfThePicture) {
  CameraModel camera = test_camera(0);
  camera.set_orientation(0, 1.5, 0);
  EXPECT_EQ(GroundPlane(camera, 30).horizon_row_px()[90], -0.5F);
  camera.set_orientation(0, -1.5, 0);
  const GroundPlane sky(camera, 30);
  EXPECT_EQ(sky.horizon_row_px()[90], 119.5F);
  EXPECT_TRUE(std::isnan(sky.at(90, 119).x_m));
}

}  // namespace
}  // namespace hindsight
