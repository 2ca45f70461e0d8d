// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/world/lane.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hindsight {
namespace {

/// A second wave beside the first, so that no wind is like the one before.
constexpr double kFirstShare = 0.7;
constexpr double kSecondShare = 0.3;
constexpr double kSecondPace = 1.9;

constexpr double kLookAround_m = 4.0;
constexpr double kStep_m = 0.25;

}  // namespace

Lane::Lane(const TrailParams& trail, Random random)
    : swing_m_(trail.width_m > 0.0 ? trail.swing_m : 0.0),
      radpm_(2.0 * std::numbers::pi / trail.period_m),
      phase_rad_(random.uniform(0.0, 2.0 * std::numbers::pi)),
      second_phase_rad_(random.uniform(0.0, 2.0 * std::numbers::pi)) {}

double Lane::wave_m(double x_m) const {
  return swing_m_ * (kFirstShare * std::sin(radpm_ * x_m + phase_rad_) +
                     kSecondShare * std::sin(kSecondPace * radpm_ * x_m + second_phase_rad_));
}

double Lane::y_m(double x_m) const { return wave_m(x_m) - wave_m(0.0); }

double Lane::heading_rad(double x_m) const {
  return std::atan(swing_m_ * radpm_ *
                   (kFirstShare * std::cos(radpm_ * x_m + phase_rad_) +
                    kSecondShare * kSecondPace * std::cos(kSecondPace * radpm_ * x_m + second_phase_rad_)));
}

double Lane::distance_m(WorldPoint p) const {
  double nearest_m = std::abs(p.y_m - y_m(p.x_m));
  if (swing_m_ == 0.0) return nearest_m;
  for (double x_m = p.x_m - kLookAround_m; x_m <= p.x_m + kLookAround_m; x_m += kStep_m) {
    nearest_m = std::min(nearest_m, std::hypot(x_m - p.x_m, y_m(x_m) - p.y_m));
  }
  return nearest_m;
}

}  // namespace hindsight
