// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/vehicle/body_contact.h"

#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

/// Enough for millimetres between a rectangle and a segment.
constexpr int kProjections = 12;
/// The bumper also gives when hit at its corner, but not from the side.
constexpr double kLeastForward = 0.3;

}  // namespace

WorldPoint PlanarPose::to_world(WorldPoint in_body) const {
  const double c = std::cos(heading_rad), s = std::sin(heading_rad);
  return {x_m + c * in_body.x_m - s * in_body.y_m, y_m + s * in_body.x_m + c * in_body.y_m};
}

WorldPoint PlanarPose::to_body(WorldPoint in_world) const {
  const double c = std::cos(heading_rad), s = std::sin(heading_rad);
  const double dx = in_world.x_m - x_m, dy = in_world.y_m - y_m;
  return {c * dx + s * dy, -s * dx + c * dy};
}

BodyContact body_contact(const VehicleParams& vehicle, const PlanarPose& X_WB, const Obstacle& obstacle) {
  const WorldPoint a = X_WB.to_body(obstacle.a), b = X_WB.to_body(obstacle.b);
  const double front_m = vehicle.front_m - kBumperTravel_m, side_m = 0.5 * vehicle.width_m;
  // Nearest points of two convex sets by projecting from one to the other and back (von Neumann).
  WorldPoint body{}, axis{};
  for (int i = 0; i < kProjections; ++i) {
    axis = nearest_on_segment(a, b, body);
    const WorldPoint nearer{std::clamp(axis.x_m, -vehicle.rear_m, front_m),
                            std::clamp(axis.y_m, -side_m, side_m)};
    if (nearer.x_m == body.x_m && nearer.y_m == body.y_m) break;
    body = nearer;
  }
  const double dx = axis.x_m - body.x_m, dy = axis.y_m - body.y_m;
  const double distance_m = std::hypot(dx, dy);
  BodyContact contact{distance_m - obstacle.radius_m, body, {1.0, 0.0}};
  if (distance_m > 0.0) contact.towards = {dx / distance_m, dy / distance_m};
  return contact;
}

double bumper_pressed_m(const VehicleParams& vehicle, const BodyContact& contact) {
  const bool in_front =
      contact.at.x_m >= vehicle.front_m - kBumperTravel_m && contact.towards.x_m > kLeastForward;
  return in_front ? std::clamp(kBumperTravel_m - contact.gap_m, 0.0, kBumperTravel_m) : 0.0;
}

}  // namespace hindsight
