// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/ground_odometry.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "perception/ground_plane.h"
#include "perception/optical_flow.h"

namespace hindsight {
namespace {

const CameraModel& camera() {
  static const CameraModel model = read_camera_model(HINDSIGHT_SOURCE_DIR "/config/camera.yaml");
  return model;
}

/// How B moved between two frames: B now in B then.
struct Move {
  double forward_m = 0.0;
  double turn_rad = 0.0;
  double pitch_rad = 0.0;
  double roll_rad = 0.0;

  Eigen::Vector3d then(const Eigen::Vector3d& p_BP_m) const {
    const Eigen::Matrix3d R = (Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) *
                               Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX()))
                                  .toRotationMatrix();
    return R * p_BP_m + Eigen::Vector3d(forward_m, 0.0, 0.0);
  }
};

/// Flow of a point of the plane z = height in B now. The chassis stands as it should now, not before.
std::optional<FlowVector> flow_at(ImagePoint pixel, const Move& move, double height_m = 0.0) {
  const Eigen::Vector3d ray = camera().ray_B(pixel);
  if (ray.z() >= 0.0) return std::nullopt;
  const Eigen::Vector3d p_BP_m = camera().p_BC_m + (height_m - camera().p_BC_m.z()) / ray.z() * ray;
  const auto then = camera().project(move.then(p_BP_m));
  if (!then) return std::nullopt;
  return FlowVector{static_cast<float>(pixel.x_px), static_cast<float>(pixel.y_px),
                    static_cast<float>(then->x_px - pixel.x_px), static_cast<float>(then->y_px - pixel.y_px)};
}

struct Scene {
  double noise_px = 0.0;
  double wrong_share = 0.0;  ///< matched anywhere within 15 px
  unsigned seed = 1;
};

std::vector<FlowVector> ground_flow(const Move& move, const Scene& scene = {}) {
  std::mt19937 random(scene.seed);
  std::normal_distribution<float> noise(0.0F, static_cast<float>(scene.noise_px));
  std::uniform_real_distribution<double> any(0.0, 1.0);
  std::uniform_real_distribution<float> wrong_px(-15.0F, 15.0F);
  std::vector<FlowVector> flow;
  for (int i = 0; i < 1500; ++i) {
    auto v = flow_at({any(random) * 719.0, any(random) * 479.0}, move);
    if (!v) continue;
    if (scene.noise_px > 0.0) v->dx_px += noise(random), v->dy_px += noise(random);
    if (any(random) < scene.wrong_share) v->dx_px = wrong_px(random), v->dy_px = wrong_px(random);
    flow.push_back(*v);
  }
  return flow;
}

OdometryMotion measure(const std::vector<FlowVector>& flow) {
  return GroundOdometry(GroundOdometryParams{}, camera()).measure(flow);
}

TEST(GroundOdometry, MeasuresWayAndTurn) {
  for (const Move& move : {Move{0.1, 0.0}, Move{-0.06, 0.0}, Move{0.0, 0.05}, Move{0.13, -0.08}, Move{}}) {
    const OdometryMotion measured = measure(ground_flow(move));
    EXPECT_TRUE(measured.valid);
    EXPECT_NEAR(measured.forward_m, move.forward_m, 1e-3) << move.forward_m << " " << move.turn_rad;
    // Rotations are taken to be small.
    EXPECT_NEAR(measured.turn_rad, move.turn_rad, 1e-4 + 0.03 * std::abs(move.turn_rad)) << move.forward_m;
  }
}

TEST(GroundOdometry, TellsPitchAndRollFromDriving) {
  for (const double pitch_rad : {-0.02, 0.02}) {
    const OdometryMotion standing = measure(ground_flow({0.0, 0.0, pitch_rad, 0.5 * pitch_rad}));
    EXPECT_TRUE(standing.valid);
    EXPECT_NEAR(standing.forward_m, 0.0, 3e-3) << pitch_rad;
    EXPECT_NEAR(measure(ground_flow({0.1, 0.02, pitch_rad, -pitch_rad})).forward_m, 0.1, 5e-3) << pitch_rad;
  }
}

TEST(GroundOdometry, BearsNoiseAndWrongMatches) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const OdometryMotion measured = measure(
        ground_flow({0.1, 0.02, 0.005, -0.005}, {.noise_px = 0.5, .wrong_share = 0.25, .seed = seed}));
    EXPECT_TRUE(measured.valid) << seed;
    EXPECT_NEAR(measured.forward_m, 0.1, 5e-3) << seed;
    EXPECT_LT(measured.sigma_m, 2e-3) << seed;
  }
}

TEST(GroundOdometry, BearsThingsThatStandOnTheGround) {
  std::vector<FlowVector> flow = ground_flow({0.1});
  const std::size_t ground = flow.size();
  for (double x = 300.0; x < 420.0; x += 8.0) {
    for (double y = 250.0; y < 420.0; y += 8.0) {
      if (const auto v = flow_at({x, y}, {0.1}, 0.5)) flow.push_back(*v);
    }
  }
  ASSERT_GT(flow.size(), ground + 200);
  std::shuffle(flow.begin(), flow.end(), std::mt19937(3));
  const OdometryMotion measured = measure(flow);
  EXPECT_TRUE(measured.valid);
  EXPECT_NEAR(measured.forward_m, 0.1, 0.01);
}

TEST(GroundOdometry, TellsNothingWhereVectorsDisagree) {
  EXPECT_FALSE(measure(ground_flow({0.1}, {.wrong_share = 0.9})).valid);
}

TEST(GroundOdometry, TellsNothingOfTooLittleGround) {
  EXPECT_FALSE(measure({}).valid);
  std::vector<FlowVector> flow = ground_flow({0.1});
  std::vector<FlowVector> sky, few;
  for (const FlowVector& v : flow) {
    const auto p = ground_point(camera(), {static_cast<double>(v.x_px), static_cast<double>(v.y_px)});
    if (p->x_m > 4.5) sky.push_back(v);
    if (p->x_m < 3.0 && few.size() < 20) few.push_back(v);
  }
  ASSERT_GT(sky.size(), 40U);
  EXPECT_FALSE(measure(sky).valid) << "all of it too far away";
  EXPECT_FALSE(measure(few).valid);
}

TEST(GroundOdometry, TellsNothingOfOneSpot) {
  std::vector<FlowVector> flow;
  std::mt19937 random(2);
  std::normal_distribution<float> noise(0.0F, 0.5F);
  for (double x = 355.0; x < 365.0; x += 1.0) {
    for (double y = 300.0; y < 310.0; y += 1.0) {
      if (auto v = flow_at({x, y}, {0.1})) {
        v->dx_px += noise(random), v->dy_px += noise(random);
        flow.push_back(*v);
      }
    }
  }
  ASSERT_EQ(flow.size(), 100U);
  EXPECT_FALSE(measure(flow).valid) << "driving and pitching look alike there";
}

/// A car at 4 to 15 m/s, whose camera sees the ground from 6 m on. Its true speed is not at hand; a speed
/// that does not jump is.
TEST(GroundOdometry, GivesASteadySpeedOfARealCar) {
  const char* data = std::getenv("HINDSIGHT_DATA");
  if (data == nullptr) GTEST_SKIP() << "HINDSIGHT_DATA is not set";
  CameraModel car;
  car.width_px = 1242, car.height_px = 375;
  car.fx_px = car.fy_px = 721.54, car.cx_px = 609.56, car.cy_px = 172.85;
  car.p_BC_m = {0.0, 0.0, 1.65};
  car.set_orientation(0.0, 0.0, 0.0);
  car.set_field_of_view();
  GroundOdometryParams params;
  params.max_range_m = 16.0;
  GroundOdometry odometry(params, car);
  OpticalFlow flow(OpticalFlowParams{}, car.width_px, car.height_px);
  std::vector<OdometryMotion> steps;
  for (int i = 150; i < 250; ++i) {
    char name[32];
    std::snprintf(name, sizeof(name), "/%06d.jpg", i);
    const cv::Mat frame = cv::imread(std::string(data) + "/road_kitti0019" + name);
    ASSERT_FALSE(frame.empty()) << name;
    const auto vectors = flow.update({frame.data, frame.total() * 3});
    if (i > 150) steps.push_back(odometry.measure(vectors));
  }
  std::vector<double> jumps;
  for (std::size_t i = 2; i < steps.size(); ++i) {
    if (!steps[i].valid || !steps[i - 1].valid || !steps[i - 2].valid) continue;
    const double mean_m = (steps[i].forward_m + steps[i - 2].forward_m) / 2;
    jumps.push_back(std::abs(steps[i - 1].forward_m / mean_m - 1.0));
  }
  ASSERT_GT(jumps.size(), 85U);
  std::sort(jumps.begin(), jumps.end());
  EXPECT_LT(jumps[jumps.size() / 2], 0.02);
  EXPECT_LT(jumps.back(), 0.1);
}

}  // namespace
}  // namespace hindsight
