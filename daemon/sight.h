// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What the camera makes of the world: flow and its history, how things looked, labels of every pixel, votes
// on the ground.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "daemon/robot_config.h"
#include "drivers/samples.h"
#include "perception/appearance_history.h"
#include "perception/bottom_finder.h"
#include "perception/camera_model.h"
#include "perception/flow_history.h"
#include "perception/ground_odometry.h"
#include "perception/ground_plane.h"
#include "perception/optical_flow.h"
#include "perception/road_follower.h"
#include "perception/road_ground.h"
#include "perception/segmenter.h"
#include "perception/terrain_labeller.h"

namespace hindsight {

class Sight {
 public:
  Sight(const Configuration& configuration, const CameraModel& camera);

  /// Takes a frame into the histories. False, and nothing changes, if it has another size than the
  /// calibration.
  bool see(const Frame& frame);
  /// Labels every pixel of the frame last seen and finds where obstacles stand. Call after see() returned
  /// true.
  void classify(const Frame& frame, const TerrainMixture& mixture, const TextureModel& texture);

  const OpticalFlow& flow() const { return flow_; }
  std::span<const FlowVector> vectors() const { return vectors_; }
  /// Over the ground, from the frame before to the one last seen; null where that was the first, or nobody asks.
  const GroundStep* ground_step() const { return ground_step_ ? &*ground_step_ : nullptr; }
  const FlowHistory& history() const { return history_; }
  const AppearanceHistory& appearance() const { return appearance_; }
  const GroundPlane& ground() const { return ground_; }
  const BottomFinder& bottom_finder() const { return bottom_finder_; }
  std::span<const TerrainClass> labels() const { return labels_; }
  std::array<int, kLabelCount + 1> label_counts() const { return count_labels(labels_); }
  std::span<const GroundVote> votes() const { return votes_; }
  /// Null where the road is not looked for.
  const RoadFollower* road() const { return road_ ? &*road_ : nullptr; }
  /// Empty, too, where none is seen.
  const RoadOnGround& road_on_ground() const { return road_on_ground_; }

 private:
  bool interrupted(const Frame& frame) const;
  void forget();
  void follow_road(Time dt);

  CameraModel camera_;
  int width_px_;
  int height_px_;
  OpticalFlow flow_;
  FlowHistory history_;
  AppearanceHistory appearance_;
  GroundPlane ground_;
  std::optional<GroundOdometry> odometry_;  ///< where slip is told by it
  BottomFinder bottom_finder_;
  Segmenter segmenter_;
  TerrainLabeller labeller_;
  bool any_frame_ = false;
  Time last_stamp_{};
  std::uint32_t last_sequence_ = 0;
  std::span<const FlowVector> vectors_;
  std::optional<GroundStep> ground_step_;
  std::span<const TerrainClass> labels_;
  std::span<const GroundVote> votes_;
  std::optional<RoadFollower> road_;
  RoadOnGround road_on_ground_;
};

}  // namespace hindsight
