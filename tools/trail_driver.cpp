// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/trail_driver.h"

#include <cmath>
#include <numbers>

#include "config/exit_code.h"

namespace hindsight::tools {
namespace {

constexpr double kLookAhead_m = 3.0;
constexpr double kArrived_m = 3.0;

double distance_m(WorldPoint a, WorldPoint b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

const Trail& only_trail(const World& world) {
  if (world.trails.empty()) throw FatalError(kExitBadData, world.name + ": has no trail to drive along");
  return world.trails.front();
}

}  // namespace

TrailDriver::TrailDriver(const World& world, double track_width_m)
    : trail_(only_trail(world)), goal_(world.goal), half_track_m_(track_width_m / 2) {}

WheelCommand TrailDriver::drive(const SimVehicle& vehicle) {
  const BodyPose& X_WB = vehicle.pose();
  find_nearest({X_WB.x_m, X_WB.y_m});
  const WorldPoint aim = target(vehicle.distance_m());
  const double ahead_m = distance_m(aim, {X_WB.x_m, X_WB.y_m});
  const double bearing_rad = std::atan2(aim.y_m - X_WB.y_m, aim.x_m - X_WB.x_m) - X_WB.heading_rad;
  const double curvature_per_m = 2.0 * std::sin(bearing_rad) / ahead_m;
  return {kSpeed_mps * (1.0 - curvature_per_m * half_track_m_),
          kSpeed_mps * (1.0 + curvature_per_m * half_track_m_)};
}

bool TrailDriver::arrived(const SimVehicle& vehicle) const {
  return distance_m(WorldPoint{vehicle.pose().x_m, vehicle.pose().y_m}, goal_) < kArrived_m;
}

void TrailDriver::find_nearest(WorldPoint at) {
  while (nearest_ + 1 < trail_.centre.size() &&
         distance_m(trail_.centre[nearest_ + 1], at) <= distance_m(trail_.centre[nearest_], at)) {
    ++nearest_;
  }
}

/// A point of the swaying line, kLookAhead_m further along.
WorldPoint TrailDriver::target(double driven_m) const {
  std::size_t i = nearest_;
  while (i + 2 < trail_.centre.size() && distance_m(trail_.centre[i], trail_.centre[nearest_]) < kLookAhead_m)
    ++i;
  const WorldPoint a = trail_.centre[i], b = trail_.centre[i + 1];
  const double aside_m =
      kSway_m * std::sin(2.0 * std::numbers::pi * (driven_m + kLookAhead_m) / kSwayPeriod_m);
  const double length_m = distance_m(a, b);
  return {a.x_m - aside_m * (b.y_m - a.y_m) / length_m, a.y_m + aside_m * (b.x_m - a.x_m) / length_m};
}

}  // namespace hindsight::tools
