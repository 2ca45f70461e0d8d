// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/road_guide.h"

#include <cmath>

namespace hindsight {
namespace {

/// A goal that the road has moved by less stays.
constexpr double kMoved_m = 0.5;

double distance_m(const Point2& a, const Point2& b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

/// The robot gets out of where it is caught before it looks at the road again.
bool recovers(Behaviour behaviour) {
  return behaviour == Behaviour::stopping || behaviour == Behaviour::back_up ||
         behaviour == Behaviour::turn_away;
}

}  // namespace

std::optional<Point2> RoadGuide::goal_W(const Pose2& X_WB, const RoadOnGround& road,
                                        const std::optional<Point2>& mission_W, Behaviour behaviour) {
  if (mission_W && distance_m(*mission_W, {X_WB.x_m, X_WB.y_m}) < look_ahead_m_) return mission_W;
  if (held_W_ && recovers(behaviour)) return held_W_;
  const std::optional<Point2> ahead_B = point_ahead_B(road, look_ahead_m_);
  if (!ahead_B) {
    // Back to where it was last seen: a robot that has backed up and turned away may look past the road.
    if (behaviour == Behaviour::arrived) held_W_.reset();
    return held_W_;
  }
  const Point2 ahead_W = X_WB * *ahead_B;
  if (!held_W_ || distance_m(*held_W_, ahead_W) > kMoved_m) held_W_ = ahead_W;
  return held_W_;
}

}  // namespace hindsight
