// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/segmentation_score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "perception/camera_model.h"
#include "tools/builtin_config.h"

namespace hindsight::tools {
namespace {

constexpr double kRange_m = 25.0;

struct Scene {
  CameraModel camera = parse_camera_model(builtin_calibration(), "built-in");
  World world;
  RenderedFrame frame;

  /// Flat ground, seen from where the world begins.
  Scene() {
    for (int row = 0; row < camera.height_px; ++row) {
      for (int column = 0; column < camera.width_px; ++column) {
        const Eigen::Vector3d ray = camera.ray_B({static_cast<double>(column), static_cast<double>(row)});
        const bool ground = ray.z() < 0.0;
        frame.labels.push_back(ground ? TruthLabel::ground : TruthLabel::sky);
        frame.objects.push_back(0);
        frame.depth_m.push_back(ground ? static_cast<float>(-camera.p_BC_m.z() / ray.z())
                                       : std::numeric_limits<float>::infinity());
      }
    }
  }
  std::size_t pixel(int column, int row) const {
    return static_cast<std::size_t>(row * camera.width_px + column);
  }
  /// A wall across some columns and rows, standing `away_m` in front of the camera.
  void put_wall(std::uint16_t number, int left, int right, int top, int bottom, float away_m) {
    for (int row = top; row < bottom; ++row) {
      for (int column = left; column < right; ++column) {
        frame.labels[pixel(column, row)] = TruthLabel::tree;
        frame.objects[pixel(column, row)] = number;
        frame.depth_m[pixel(column, row)] = away_m;
      }
    }
  }
};

TEST(SegmentationScore, NearAndFarObstaclesWeighTheSame) {
  Scene scene;
  scene.put_wall(1, 100, 200, 200, 300, 3.0F);  // 10,000 pixels
  scene.put_wall(2, 400, 410, 150, 160, 9.0F);  // 100
  const SegmentationJudge judge(scene.camera, kRange_m);
  const SegmentationTruth truth = judge.truth_of(scene.frame, {}, scene.world);
  std::vector<TerrainClass> labels(scene.frame.labels.size(), TerrainClass::good);
  for (int row = 150; row < 160; ++row) {
    for (int column = 400; column < 410; ++column) labels[scene.pixel(column, row)] = TerrainClass::lethal;
  }
  const SegmentationScore score = judge.judge(truth, labels);
  EXPECT_EQ(score.obstacles, 2);
  EXPECT_NEAR(score.coverage_sum, 1.0, 1e-9);  // all of the far one, nothing of the near one
  EXPECT_EQ(score.wrong_m2, 0.0);
}

TEST(SegmentationScore, GroundCountsByItsArea) {
  const Scene scene;
  const SegmentationJudge judge(scene.camera, kRange_m);
  const SegmentationTruth truth = judge.truth_of(scene.frame, {}, scene.world);
  // Wrong is what lies beyond 10 m: few pixels, most of the area.
  std::vector<TerrainClass> labels(scene.frame.labels.size(), TerrainClass::good);
  int wrong_px = 0, ground_px = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!truth.is_ground[i] || scene.frame.depth_m[i] > 25.0F) continue;
    ++ground_px;
    if (scene.frame.depth_m[i] < 10.0F) continue;
    labels[i] = TerrainClass::bad;
    ++wrong_px;
  }
  const SegmentationScore score = judge.judge(truth, labels);
  EXPECT_LT(wrong_px, ground_px / 4);
  EXPECT_GT(score.wrong_m2 / score.ground_m2, 0.7);
  // A sector of the camera's opening angle, 25 m long.
  const double angle_rad = 2.0 * std::atan(0.5 * scene.camera.width_px / scene.camera.fx_px);
  EXPECT_NEAR(score.ground_m2, 0.5 * angle_rad * kRange_m * kRange_m, 0.15 * score.ground_m2);
}

TEST(SegmentationScore, CrownsAboveTheVehicleAreNoObstacle) {
  Scene scene;
  scene.put_wall(1, 300, 340, 0, 40, 8.0F);  // all of it higher than 1.5 m
  const SegmentationJudge judge(scene.camera, kRange_m);
  const SegmentationTruth truth = judge.truth_of(scene.frame, {}, scene.world);
  const std::vector<TerrainClass> labels(scene.frame.labels.size(), TerrainClass::good);
  EXPECT_EQ(judge.judge(truth, labels).obstacles, 0);
}

}  // namespace
}  // namespace hindsight::tools
