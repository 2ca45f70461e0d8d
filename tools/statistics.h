// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace hindsight::tools {

/// 0 of nothing.
double mean_of(std::span<const double> values);
/// The value that `part` (0 to 1) of the values do not exceed: one of them, no interpolation. 0 of nothing.
double quantile_of(std::vector<double> values, double part);

/// Paired permutation test: how likely differences of equal size but random sign have a mean as far from 0 as
/// these have. From 100,000 draws of the signs, so never below 1e-5. `seed` makes it repeatable.
double sign_flip_p_value(std::span<const double> differences, std::uint64_t seed);

/// Half axes and direction of the ellipse that holds 95 % of a normal distribution with the points'
/// covariance.
struct Ellipse {
  double x = 0.0, y = 0.0;
  double major = 0.0, minor = 0.0;
  double angle_rad = 0.0;  ///< of the major axis, from x towards y
};
Ellipse ellipse_95(std::span<const double> x, std::span<const double> y);

}  // namespace hindsight::tools
