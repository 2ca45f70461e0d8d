// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "config/vehicle_params.h"
#include "sim_replay/world/obstacle.h"

namespace hindsight {

/// Where the vehicle is on the map: position of B in W and heading, counter-clockwise from east.
struct PlanarPose {
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;

  WorldPoint to_world(WorldPoint in_body) const;
  WorldPoint to_body(WorldPoint in_world) const;
};

/// How far the bumper gives before the body behind it touches.
constexpr double kBumperTravel_m = 0.03;

/// The nearest points of the rigid body, a rectangle without the bumper's travel, and an obstacle; in B.
struct BodyContact {
  double gap_m = 0.0;  ///< negative where they overlap
  WorldPoint at;       ///< on the body
  WorldPoint towards;  ///< unit vector to the obstacle; meaningless where its axis is inside the body
};

BodyContact body_contact(const VehicleParams& vehicle, const PlanarPose& X_WB, const Obstacle& obstacle);

/// How far an obstacle has pressed the bumper in; 0 where it does not touch it.
double bumper_pressed_m(const VehicleParams& vehicle, const BodyContact& contact);

}  // namespace hindsight
