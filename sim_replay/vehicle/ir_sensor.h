// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>

#include "sim_replay/vehicle/body_contact.h"
#include "sim_replay/world/obstacle.h"
#include "sim_replay/world/random.h"

namespace hindsight {

/// Where an IR range sensor sits on the body and how it looks: a cone, level and straight ahead.
struct IrMount {
  double x_m = 0.35;
  double y_m = 0.25;
  double height_m = 0.4;
  double half_angle_rad = 0.10;
  double longest_m = 1.5;
};

/// From a point along a direction (of length 1) to an obstacle's surface; infinite where the ray misses it, 0
/// inside.
double ray_range_m(WorldPoint from, WorldPoint direction, const Obstacle& obstacle);

/// The range that the sensor measures, without noise: to the nearest point that its cone meets. Things that
/// fill little of the cone, are dark or far may send back too little to be seen; the longest range then.
double ir_range_m(const IrMount& mount, const PlanarPose& X_WB, std::span<const Obstacle> obstacles);

/// The same as the sensor tells it.
double ir_reading_m(const IrMount& mount, double range_m, Random& random);

}  // namespace hindsight
