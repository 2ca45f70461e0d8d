// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/pose_filter.h"

#include <Eigen/LU>
#include <cmath>

namespace hindsight {

using Eigen::Matrix2d;
using Eigen::Vector2d;

PoseFilter::PoseFilter(const Pose2& X_WB, double heading_rad2, double bias_radps, double bias_radps2)
    : state_(X_WB.x_m, X_WB.y_m, X_WB.heading_rad, bias_radps) {
  covariance_(2, 2) = heading_rad2;
  covariance_(3, 3) = bias_radps2;
}

void PoseFilter::propagate(const Motion& motion) {
  const double turn_rad = motion.turn_rad - (motion.from_gyro ? state_(3) * motion.dt_s : 0.0);
  const double c = std::cos(state_(2) + 0.5 * turn_rad), s = std::sin(state_(2) + 0.5 * turn_rad);
  state_ += Vector4(motion.way_m * c, motion.way_m * s, turn_rad, 0.0);
  state_(2) = wrap_angle(state_(2));

  // G: how noise enters, column by column: along the way, sideways, turn (half of which bends the way), bias.
  Matrix4 G;
  G.col(0) << c, s, 0.0, 0.0;
  G.col(1) << -s, c, 0.0, 0.0;
  G.col(2) << -0.5 * motion.way_m * s, 0.5 * motion.way_m * c, 1.0, 0.0;
  G.col(3) << 0.0, 0.0, 0.0, 1.0;
  Matrix4 F = Matrix4::Identity();
  F(0, 2) = -motion.way_m * s;
  F(1, 2) = motion.way_m * c;
  if (motion.from_gyro) F.col(3) -= motion.dt_s * G.col(2);
  const Vector4 noise(motion.along_m2, motion.lateral_m2, motion.turn_rad2, motion.bias_radps2);
  const Matrix4 old = covariance_;
  covariance_ = F * old * F.transpose() + G * noise.asDiagonal() * G.transpose();
}

void PoseFilter::measure_bias(double bias_radps, double variance_radps2, double gate) {
  const double innovation = bias_radps - state_(3);
  const double variance = covariance_(3, 3) + variance_radps2;
  if (innovation * innovation > gate * gate * variance) return;
  const Vector4 gain = covariance_.col(3) / variance;
  state_ += gain * innovation;
  state_(2) = wrap_angle(state_(2));
  const Matrix4 explained = variance * gain * gain.transpose();
  covariance_ -= explained;
}

double PoseFilter::mahalanobis(const Point2& offset_m, double variance_m2) const {
  const Vector2d innovation(offset_m.x_m, offset_m.y_m);
  const Matrix2d S = covariance_.topLeftCorner<2, 2>() + variance_m2 * Matrix2d::Identity();
  return std::sqrt(innovation.dot(S.inverse() * innovation));
}

void PoseFilter::measure_position(const Point2& offset_m, double variance_m2) {
  const Matrix2d S = covariance_.topLeftCorner<2, 2>() + variance_m2 * Matrix2d::Identity();
  const Eigen::Matrix<double, 4, 2> gain = covariance_.leftCols<2>() * S.inverse();
  state_ += gain * Vector2d(offset_m.x_m, offset_m.y_m);
  state_(2) = wrap_angle(state_(2));
  // Joseph's form, which stays symmetric and positive: (I - K H) P (I - K H)' + K R K'.
  Matrix4 keep = Matrix4::Identity();
  keep.leftCols<2>() -= gain;
  const Matrix4 old = covariance_;
  covariance_ = keep * old * keep.transpose() + variance_m2 * gain * gain.transpose();
}

void PoseFilter::reset_position(const Point2& p_WB_m, double variance_m2) {
  state_.head<2>() << p_WB_m.x_m, p_WB_m.y_m;
  covariance_.topRows<2>().setZero();
  covariance_.leftCols<2>().setZero();
  covariance_(0, 0) = covariance_(1, 1) = variance_m2;
}

void PoseFilter::reset_heading(double heading_rad, double variance_rad2) {
  state_(2) = wrap_angle(heading_rad);
  covariance_.row(2).setZero();
  covariance_.col(2).setZero();
  covariance_(2, 2) = variance_rad2;
}

void PoseFilter::add_frame_doubt(const Point2& lever_m, double rotation_rad2, double shift_m2) {
  const Vector4 moved_by_rotation(-lever_m.y_m, lever_m.x_m, 1.0, 0.0);
  const Matrix4 rotation = rotation_rad2 * moved_by_rotation * moved_by_rotation.transpose();
  covariance_ += rotation;
  covariance_(0, 0) += shift_m2;
  covariance_(1, 1) += shift_m2;
}

}  // namespace hindsight
