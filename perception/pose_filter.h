// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <Eigen/Core>

#include "perception/pose.h"

namespace hindsight {

/// What moves the state in one step. The variances are of the whole step.
struct Motion {
  double dt_s = 0.0;
  double way_m = 0.0;
  double turn_rad = 0.0;  ///< as measured; with its bias if from_gyro
  bool from_gyro = false;
  double along_m2 = 0.0;    ///< of way_m
  double lateral_m2 = 0.0;  ///< of the way sideways
  double turn_rad2 = 0.0;
  double bias_radps2 = 0.0;
};

/// Extended Kalman filter of the planar pose and the gyro's bias (Thrun, Burgard, Fox: Probabilistic
/// Robotics, 3.3 and 5.4): the equations only. What they are fed with is Localisation's business. No
/// allocation.
class PoseFilter {
 public:
  using Vector4 = Eigen::Matrix<double, 4, 1>;
  using Matrix4 = Eigen::Matrix<double, 4, 4>;

  PoseFilter(const Pose2& X_WB, double heading_rad2, double bias_radps, double bias_radps2);

  void propagate(const Motion& motion);
  /// A measurement of the bias, ignored where it is farther than `gate` standard deviations off.
  void measure_bias(double bias_radps, double variance_radps2, double gate);

  /// Mahalanobis distance of a measured position that is off by (dx, dy), each axis with variance_m2.
  double mahalanobis(const Point2& offset_m, double variance_m2) const;
  /// Corrects the state with it.
  void measure_position(const Point2& offset_m, double variance_m2);

  /// Sets position or heading to a value known independently of all else.
  void reset_position(const Point2& p_WB_m, double variance_m2);
  void reset_heading(double heading_rad, double variance_rad2);
  /// Adds the doubt of a rotation about, and a shift of, a point from which the vehicle is `lever_m` away (in
  /// W).
  void add_frame_doubt(const Point2& lever_m, double rotation_rad2, double shift_m2);

  Pose2 pose() const { return {state_(0), state_(1), state_(2)}; }
  double bias_radps() const { return state_(3); }
  /// Of x, y, heading, bias.
  const Matrix4& covariance() const { return covariance_; }

 private:
  Vector4 state_;
  Matrix4 covariance_ = Matrix4::Zero();
};

}  // namespace hindsight
