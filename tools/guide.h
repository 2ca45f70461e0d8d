// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// An operator with a map: drives a simulated vehicle into some trees on purpose, then through the world
// without touching anything. Stands in for the person who guided the robot in the thesis' training drives
// (5.2.2).
#pragma once

#include <optional>
#include <vector>

#include "sim_replay/vehicle/sim_vehicle.h"
#include "sim_replay/world/obstacle.h"
#include "sim_replay/world/world.h"

namespace hindsight::tools {

class Guide {
 public:
  /// bumps: trees to drive into before the tour, which goes to and fro between start and goal.
  Guide(const World& world, double track_width_m, int bumps);

  /// What the wheels are to be told now.
  WheelCommand drive(const SimVehicle& vehicle, Time now);

  /// All trees that were to be met have been.
  bool touring() const { return bumps_left_ == 0 && !backing_until_; }

 private:
  WheelCommand steer(double speed_mps, double curvature_per_m) const;
  WheelCommand drive_at(const BodyPose& X_WB, WorldPoint target) const;
  WheelCommand tour(const BodyPose& X_WB);
  std::optional<WorldPoint> choose_tree(const BodyPose& X_WB) const;
  double clearance_m(const BodyPose& X_WB, double curvature_per_m, double ahead_m) const;
  bool in_sight(const BodyPose& X_WB, WorldPoint tree) const;

  std::vector<Obstacle> obstacles_;
  std::vector<WorldPoint> trees_;
  std::vector<WorldPoint> met_;
  std::vector<WorldPoint> stops_;  ///< of the tour
  std::size_t next_stop_ = 0;
  double half_track_m_;
  int bumps_left_;
  int touches_ = 0;
  std::optional<WorldPoint> target_;
  std::optional<Time> backing_until_;
  bool turning_ = false;
};

}  // namespace hindsight::tools
