// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "sim_replay/world/course_params.h"
#include "sim_replay/world/random.h"
#include "sim_replay/world/world.h"

namespace hindsight {

/// The line that a course follows eastwards, through the origin: straight, or winding as its trail does.
class Lane {
 public:
  /// Draws where it winds.
  Lane(const TrailParams& trail, Random random);

  /// North of the x axis.
  double y_m(double x_m) const;
  double heading_rad(double x_m) const;
  /// `aside_m` to the north of it.
  WorldPoint at(double x_m, double aside_m) const { return {x_m, y_m(x_m) + aside_m}; }
  /// From a point to its middle, near enough for what stands beside it.
  double distance_m(WorldPoint p) const;

 private:
  double wave_m(double x_m) const;

  double swing_m_;
  double radpm_;
  double phase_rad_;
  double second_phase_rad_;
};

}  // namespace hindsight
