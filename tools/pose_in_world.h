// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <Eigen/Geometry>

#include "sim_replay/world/world.h"

namespace hindsight::tools {

/// p_W = pose_in_world(pose) * p_B, as BodyPose's comment has it.
inline Eigen::Isometry3d pose_in_world(const BodyPose& pose) {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.translate(Eigen::Vector3d(pose.x_m, pose.y_m, pose.z_m));
  X_WB.rotate(Eigen::AngleAxisd(pose.heading_rad, Eigen::Vector3d::UnitZ()) *
              Eigen::AngleAxisd(pose.pitch_rad, Eigen::Vector3d::UnitY()) *
              Eigen::AngleAxisd(pose.roll_rad, Eigen::Vector3d::UnitX()));
  return X_WB;
}

}  // namespace hindsight::tools
