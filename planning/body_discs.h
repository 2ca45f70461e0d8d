// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "config/vehicle_params.h"

namespace hindsight {

/// Covers the vehicle by discs of half its width, centred on the body's x axis: their x_B [m], from the rear
/// to the front, the driven axle's (0) always among them. In C-space the vehicle is clear where each of these
/// points is.
inline std::vector<double> body_discs_m(const VehicleParams& vehicle) {
  const double radius_m = vehicle.width_m / 2;
  std::vector<double> centres_m{0.0};
  const auto cover = [&](double reach_m, double sign) {
    const double last_m = std::max(0.0, reach_m - radius_m);
    const int count = static_cast<int>(std::ceil(last_m / radius_m));
    for (int i = 1; i <= count; ++i) centres_m.push_back(sign * last_m * i / count);
  };
  cover(vehicle.rear_m, -1.0);
  cover(vehicle.front_m, 1.0);
  std::sort(centres_m.begin(), centres_m.end());
  return centres_m;
}

}  // namespace hindsight
