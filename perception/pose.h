// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cmath>

namespace hindsight {

/// A point on the ground, in the frame that the variable's name says (p_WP_m: in W; p_BP_m: in B).
struct Point2 {
  double x_m = 0.0;
  double y_m = 0.0;
};

/// Planar pose of the body B in the world W (local east-north-up): x east, y north, heading counter-clockwise
/// from east. Named X_WB.
struct Pose2 {
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;

  /// p_WP = X_WB * p_BP
  Point2 operator*(const Point2& p_BP_m) const {
    const double c = std::cos(heading_rad), s = std::sin(heading_rad);
    return {x_m + c * p_BP_m.x_m - s * p_BP_m.y_m, y_m + s * p_BP_m.x_m + c * p_BP_m.y_m};
  }
  /// p_BP = X_WB^-1 * p_WP
  Point2 inverse_times(const Point2& p_WP_m) const {
    const double c = std::cos(heading_rad), s = std::sin(heading_rad);
    const double dx = p_WP_m.x_m - x_m, dy = p_WP_m.y_m - y_m;
    return {c * dx + s * dy, -s * dx + c * dy};
  }
};

/// The same angle in (-pi, pi].
inline double wrap_angle(double angle_rad) { return std::remainder(angle_rad, 2.0 * M_PI); }

}  // namespace hindsight
