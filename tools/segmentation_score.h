// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// How well a picture was segmented, as the thesis measures it (5.2.2): obstacles count alike however small
// they look, and ground counts by its area.
#pragma once

#include <span>
#include <vector>

#include "perception/ground_plane.h"
#include "perception/terrain_class.h"
#include "sim_replay/renderer/renderer.h"

namespace hindsight::tools {

/// Of one picture.
struct SegmentationScore {
  int obstacles = 0;          ///< in view
  double coverage_sum = 0.0;  ///< over them: share of the obstacle's pixels called bad or lethal
  double ground_m2 = 0.0;     ///< within reach, that is ground and nothing else
  double wrong_m2 = 0.0;      ///< of it, called bad or lethal
};

/// What is obstacle and what is ground in a rendered frame, by pixel.
struct SegmentationTruth {
  std::vector<std::uint16_t> obstacle;  ///< its number, or 0
  std::vector<bool> is_ground;
};

class SegmentationJudge {
 public:
  /// An obstacle's pixels count up to kTop_m above the ground that it stands on: what a vehicle can run into.
  /// Obstacles with fewer than kFewest_px such pixels are out of view.
  static constexpr double kTop_m = 1.5;
  static constexpr int kFewest_px = 30;

  /// Ground counts within max_range_m.
  SegmentationJudge(const CameraModel& camera, double max_range_m);

  SegmentationTruth truth_of(const RenderedFrame& frame, const BodyPose& X_WB, const World& world) const;
  SegmentationScore judge(const SegmentationTruth& truth, std::span<const TerrainClass> labels) const;

 private:
  Eigen::Vector3d p_BC_m_;
  std::vector<float> area_m2_;  ///< of flat ground, by pixel; 0 beyond the range
  std::vector<Eigen::Vector3f> rays_B_;
};

}  // namespace hindsight::tools
