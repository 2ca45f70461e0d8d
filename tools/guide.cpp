// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/guide.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hindsight::tools {
namespace {

constexpr double kSpeed_mps = 1.0;
constexpr double kTurn_mps = 0.3;
constexpr double kBackUp_mps = 0.4;
constexpr Time kBackUp = from_seconds(4.5);
/// Half the vehicle's width, and what its corners sweep.
constexpr double kBody_m = 0.5;
constexpr double kKeepClear_m = 0.25;
constexpr double kLook_m = 5.0;
constexpr double kStep_m = 0.25;
constexpr int kArcs = 31;
constexpr double kMostCurvature_per_m = 1.2;
/// Trees worth driving at: far enough away that the robot sees them grow.
constexpr double kNearest_m = 5.0, kFarthest_m = 14.0;
constexpr double kMostBearing_rad = 0.6;
constexpr double kArrived_m = 4.0;

double distance(WorldPoint a, WorldPoint b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

WorldPoint place(const BodyPose& X_WB) { return {X_WB.x_m, X_WB.y_m}; }

double bearing_rad(const BodyPose& X_WB, WorldPoint p) {
  return std::remainder(std::atan2(p.y_m - X_WB.y_m, p.x_m - X_WB.x_m) - X_WB.heading_rad,
                        2 * std::numbers::pi);
}

/// Where an arc from X_WB leads after `way_m`.
BodyPose along(const BodyPose& X_WB, double curvature_per_m, double way_m) {
  BodyPose end = X_WB;
  const double middle_rad = X_WB.heading_rad + 0.5 * curvature_per_m * way_m;
  end.heading_rad += curvature_per_m * way_m;
  end.x_m += way_m * std::cos(middle_rad);
  end.y_m += way_m * std::sin(middle_rad);
  return end;
}

}  // namespace

Guide::Guide(const World& world, double track_width_m, int bumps)
    : obstacles_(obstacles_of(world)),
      stops_{world.goal, world.start},
      half_track_m_(track_width_m / 2),
      bumps_left_(bumps) {
  for (const Tree& tree : world.trees) trees_.push_back(tree.at);
}

WheelCommand Guide::drive(const SimVehicle& vehicle, Time now) {
  const BodyPose& X_WB = vehicle.pose();
  if (vehicle.touches() > touches_) {
    touches_ = vehicle.touches();
    if (target_) met_.push_back(*target_);
    target_.reset();
    bumps_left_ = std::max(0, bumps_left_ - 1);
    backing_until_ = now + kBackUp;
  }
  if (backing_until_ && now < *backing_until_) return {-kBackUp_mps, -kBackUp_mps};
  backing_until_.reset();
  if (bumps_left_ > 0 && !target_) target_ = choose_tree(X_WB);
  return target_ ? drive_at(X_WB, *target_) : tour(X_WB);
}

WheelCommand Guide::steer(double speed_mps, double curvature_per_m) const {
  return {speed_mps * (1.0 - curvature_per_m * half_track_m_),
          speed_mps * (1.0 + curvature_per_m * half_track_m_)};
}

WheelCommand Guide::drive_at(const BodyPose& X_WB, WorldPoint target) const {
  const double bearing = bearing_rad(X_WB, target);
  return steer(0.7 * kSpeed_mps,
               std::clamp(2.0 * std::sin(bearing) / std::max(1.0, distance(place(X_WB), target)),
                          -kMostCurvature_per_m, kMostCurvature_per_m));
}

/// The nearest one ahead that nothing hides and that was not met yet.
std::optional<WorldPoint> Guide::choose_tree(const BodyPose& X_WB) const {
  std::optional<WorldPoint> best;
  double best_m = kFarthest_m;
  for (const WorldPoint& tree : trees_) {
    const double away_m = distance(place(X_WB), tree);
    const bool met =
        std::any_of(met_.begin(), met_.end(), [&](WorldPoint m) { return distance(m, tree) < 0.1; });
    if (met || away_m < kNearest_m || away_m > best_m || std::abs(bearing_rad(X_WB, tree)) > kMostBearing_rad)
      continue;
    if (!in_sight(X_WB, tree)) continue;
    best = tree;
    best_m = away_m;
  }
  return best;
}

bool Guide::in_sight(const BodyPose& X_WB, WorldPoint tree) const {
  const double away_m = distance(place(X_WB), tree);
  for (double way_m = 0.0; way_m < away_m - 1.0; way_m += kStep_m) {
    const double share = way_m / away_m;
    const WorldPoint p{X_WB.x_m + share * (tree.x_m - X_WB.x_m), X_WB.y_m + share * (tree.y_m - X_WB.y_m)};
    for (const Obstacle& obstacle : obstacles_) {
      if (distance(obstacle.a, tree) > 0.1 && distance_m(obstacle, p) < kBody_m + kKeepClear_m) return false;
    }
  }
  return true;
}

/// Of the body's outline along an arc: least distance to anything; negative where it would touch.
double Guide::clearance_m(const BodyPose& X_WB, double curvature_per_m, double ahead_m) const {
  double least = std::numeric_limits<double>::infinity();
  for (double way_m = kStep_m; way_m <= ahead_m; way_m += kStep_m) {
    const WorldPoint p = place(along(X_WB, curvature_per_m, way_m));
    for (const Obstacle& obstacle : obstacles_) least = std::min(least, distance_m(obstacle, p) - kBody_m);
  }
  return least;
}

/// The free arc that ends nearest to the next stop; turns on the spot where none is free.
WheelCommand Guide::tour(const BodyPose& X_WB) {
  if (distance(place(X_WB), stops_[next_stop_]) < kArrived_m) next_stop_ = (next_stop_ + 1) % stops_.size();
  const WorldPoint stop = stops_[next_stop_];
  double best_m = std::numeric_limits<double>::infinity(), best_curvature = 0.0;
  for (int i = 0; i < kArcs; ++i) {
    const double curvature = kMostCurvature_per_m * (2.0 * i / (kArcs - 1) - 1.0);
    if (clearance_m(X_WB, curvature, kLook_m) < kKeepClear_m) continue;
    const BodyPose end = along(X_WB, curvature, kLook_m);
    const double score_m = distance(place(end), stop) + 2.0 * std::abs(bearing_rad(end, stop));
    if (score_m < best_m) best_m = score_m, best_curvature = curvature;
  }
  turning_ =
      best_m == std::numeric_limits<double>::infinity() ||
      (std::abs(bearing_rad(X_WB, stop)) > 1.2 && (turning_ || std::abs(bearing_rad(X_WB, stop)) > 2.0));
  if (turning_)
    return bearing_rad(X_WB, stop) > 0.0 ? WheelCommand{-kTurn_mps, kTurn_mps}
                                         : WheelCommand{kTurn_mps, -kTurn_mps};
  return steer(kSpeed_mps, best_curvature);
}

}  // namespace hindsight::tools
