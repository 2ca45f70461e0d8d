// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The vehicle as a body on wheels: what localisation, planning and the command gate must agree on.
#pragma once

#include "config/params.h"

namespace hindsight {

/// Differential drive with two driven front wheels; the body frame B is forward-left-up, its origin on the
/// ground in the middle of the driven axle (ARCHITECTURE.md, "Frames").
struct VehicleParams {
  double track_width_m = 0.60;        ///< between the driven wheels' contact points
  double width_m = 0.80;
  double front_m = 0.35;              ///< from the driven axle to the bumper
  double rear_m = 0.75;               ///< from the driven axle to the tail
  double max_speed_mps = 1.3;         ///< of one wheel's contact point (LAGR's limit)
  double max_acceleration_mps2 = 1.5;  ///< of one wheel's contact point

  void visit(auto&& param) {
    param("track_width_m", track_width_m, Range{0.1, 3.0}, "distance between the driven wheels [m]");
    param("width_m", width_m, Range{0.1, 3.0}, "width of the whole vehicle [m]");
    param("front_m", front_m, Range{0.0, 3.0}, "from the driven axle to the front bumper [m]");
    param("rear_m", rear_m, Range{0.0, 5.0}, "from the driven axle to the tail [m]");
    param("max_speed_mps", max_speed_mps, Range{0.05, 5.0}, "fastest a wheel may run [m/s]");
    param("max_acceleration_mps2", max_acceleration_mps2, Range{0.1, 10.0}, "fastest a wheel may speed up [m/s2]");
  }
};

}  // namespace hindsight
