// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What moves by itself in the camera's view, and where in W things usually do (thesis 3).
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "daemon/robot_config.h"
#include "perception/activity_map.h"
#include "perception/camera_model.h"
#include "perception/motion_tracker.h"
#include "perception/pose.h"

namespace hindsight {

/// A track on flat ground, in W. NaN where its foot is not in sight, or at the horizon.
struct GroundMotion {
  Eigen::Vector2d p_W_m;
  Eigen::Vector2d v_W_m;  ///< [m/frame]
};

/// Anchors the activity map to W: a track's foot is projected to flat ground and carried by the pose, so that
/// the map drifts as localisation does and no more. Pure; no allocation in the steady state.
class MotionSense {
 public:
  MotionSense(const Configuration& configuration, const CameraModel& camera);

  /// The flow of a new frame; empty after an interruption, which ends all tracks.
  void see(std::span<const FlowVector> vectors, const Pose2& X_WB);

  const MotionReport& report() const { return tracker_.report(); }
  /// Of each of report().tracks.
  std::span<const GroundMotion> on_ground() const { return on_ground_; }
  const ActivityMap& map() const { return map_; }

 private:
  GroundMotion project(const Track& track, const Pose2& X_WB) const;

  CameraModel camera_;
  MotionTracker tracker_;
  ActivityMap map_;
  std::vector<GroundMotion> on_ground_;
};

}  // namespace hindsight
