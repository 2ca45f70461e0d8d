// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What the tests of localisation drive.
#pragma once

#include <Eigen/LU>
#include <GeographicLib/LocalCartesian.hpp>
#include <cmath>
#include <random>
#include <utility>

#include "perception/localisation.h"

namespace hindsight {
inline constexpr double kTick_s = 0.1;
inline constexpr double kGpsSigma_m = 1.5;
inline constexpr double kBias_radps = 0.015;

/// Fixes whose errors do not last.
inline LocalisationParams white() {
  LocalisationParams params;
  params.gps_correlation_s = 0.0;
  return params;
}
inline LocalisationParams with_heading(bool known) {
  LocalisationParams params = white();
  params.heading_known = known;
  return params;
}

/// A vehicle in E (east-north about 48 N 11 E) with the filter's own noise model, and the filter that follows
/// it.
class Drive {
 public:
  Drive(const LocalisationParams& params, const Pose2& start, unsigned seed)
      : localisation(params, VehicleParams{}), X_EB(start), params_(params), random_(seed) {}

  /// One tick at the wheel speeds given; every tenth tick brings a fix.
  void tick(double left_mps, double right_mps) {
    const double track_m = VehicleParams{}.track_width_m;
    const double v = 0.5 * (left_mps + right_mps), w = (right_mps - left_mps) / track_m;
    const double lateral_m = params_.lateral_noise_m * std::sqrt(std::abs(v) * kTick_s) * normal();
    if (!stuck) move({v * kTick_s, lateral_m, w * kTick_s});
    now += from_seconds(kTick_s);
    OdometryInput input{.now = now, .wheels_valid = wheels, .slipping = slipping, .gyro_valid = gyro};
    input.left_mps = left_mps + wheel_noise(left_mps);
    input.right_mps = right_mps + wheel_noise(right_mps);
    input.yaw_rate_radps =
        (stuck ? 0.0 : w) + kBias_radps + params_.gyro_noise_radps / std::sqrt(kTick_s) * normal();
    localisation.predict(input);
    if (gps && ++ticks_ % 10 == 0) report = localisation.correct(fix());
  }

  void curves(double seconds) {
    for (double t = 0.0; t < seconds; t += kTick_s) {
      phase_ += kTick_s;
      const double turn_mps = 0.15 * std::sin(0.2 * phase_) + 0.02;
      tick(1.0 - turn_mps, 1.0 + turn_mps);
    }
  }
  void straight(double seconds) {
    for (double t = 0.0; t < seconds; t += kTick_s) tick(1.0, 1.0);
  }
  void stand(double seconds) {
    for (double t = 0.0; t < seconds; t += kTick_s) tick(0.0, 0.0);
  }

  GpsFix fix() {
    GpsFix fix = true_fix();
    double up = 0.0;
    wander();
    earth_.Reverse(X_EB.x_m + jump_m + offset_m_.x_m, X_EB.y_m + offset_m_.y_m, 0.0, fix.latitude_deg,
                   fix.longitude_deg, up);
    return fix;
  }
  GpsFix true_fix() const {
    GpsFix fix{.stamp = now, .altitude_m = 500.0, .horizontal_sigma_m = kGpsSigma_m};
    double up = 0.0;
    earth_.Reverse(X_EB.x_m, X_EB.y_m, 0.0, fix.latitude_deg, fix.longitude_deg, up);
    return fix;
  }

  /// Estimate less truth, once W has its place on the earth.
  Eigen::Vector3d error() const {
    const GpsFix at = true_fix();
    const Point2 p_W_m = localisation.local_of(at.latitude_deg, at.longitude_deg).value();
    const PoseEstimate& e = localisation.estimate();
    return {e.X_WB.x_m - p_W_m.x_m, e.X_WB.y_m - p_W_m.y_m,
            wrap_angle(e.X_WB.heading_rad - e.heading_WE_rad - X_EB.heading_rad)};
  }
  double nees() const {
    const Eigen::Vector3d e = error();
    return e.dot(localisation.estimate().covariance.inverse() * e);
  }
  double position_error_m() const { return error().head<2>().norm(); }

  Localisation localisation;
  Pose2 X_EB;
  Time now{};
  bool gps = true, gyro = true, wheels = true, slipping = false, stuck = false;
  double jump_m = 0.0;  ///< by which fixes are off, eastwards
  Localisation::FixReport report;

 private:
  double normal() { return normal_(random_); }
  /// The error of a fix a second after the last: Gauss-Markov, or white.
  void wander() {
    const double kept = params_.gps_correlation_s > 0.0 ? std::exp(-1.0 / params_.gps_correlation_s) : 0.0;
    const double sigma_m = kGpsSigma_m * std::sqrt(1.0 - kept * kept);
    const bool first = std::exchange(wandered_, true) == false;
    offset_m_.x_m = first ? kGpsSigma_m * normal() : kept * offset_m_.x_m + sigma_m * normal();
    offset_m_.y_m = first ? kGpsSigma_m * normal() : kept * offset_m_.y_m + sigma_m * normal();
  }
  double wheel_noise(double speed_mps) {
    return params_.wheel_noise_m * std::sqrt(std::abs(speed_mps) / kTick_s) * normal();
  }
  void move(const Eigen::Vector3d& by) {
    const Pose2 middle{X_EB.x_m, X_EB.y_m, X_EB.heading_rad + 0.5 * by.z()};
    const Point2 p = middle * Point2{by.x(), by.y()};
    X_EB = {p.x_m, p.y_m, wrap_angle(X_EB.heading_rad + by.z())};
  }

  LocalisationParams params_;
  GeographicLib::LocalCartesian earth_{48.0, 11.0, 500.0};
  std::mt19937 random_;
  std::normal_distribution<double> normal_{0.0, 1.0};
  int ticks_ = 0;
  double phase_ = 0.0;
  Point2 offset_m_;  ///< of the fixes
  bool wandered_ = false;
};

}  // namespace hindsight
