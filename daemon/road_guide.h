// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What the navigator is told to reach while the robot follows a road.
#pragma once

#include <optional>

#include "perception/pose.h"
#include "perception/road_ground.h"
#include "planning/behaviours.h"

namespace hindsight {

/// A goal a little ahead in the middle of the road, so that the navigator goes round what stands on it as
/// ever. A point stays the goal until the road has moved on: each new goal interrupts what the robot is at.
class RoadGuide {
 public:
  explicit RoadGuide(double look_ahead_m) : look_ahead_m_(look_ahead_m) {}

  /// Where the road is lost, the last goal stays until the robot has arrived there; then, and before any road
  /// was seen, empty: the robot stops. `mission_W`: the operator's goal, which takes over once it is near.
  std::optional<Point2> goal_W(const Pose2& X_WB, const RoadOnGround& road,
                               const std::optional<Point2>& mission_W, Behaviour behaviour);

 private:
  double look_ahead_m_;
  std::optional<Point2> held_W_;
};

}  // namespace hindsight
