// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/vehicle/sim_wheel.h"

#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

/// What the base's own controller lets a wheel do; more than the daemon asks for.
constexpr double kSetPointAcceleration_mps2 = 2.5;
/// Of rim, gears and rotor, as a mass at the contact point.
constexpr double kInertia_kg = 25.0;
constexpr double kProportional_npmps = 2500.0;
constexpr double kIntegral_npm = 8000.0;
constexpr double kBearings_n = 10.0;
constexpr double kStandstill_mps = 0.02;
/// Slip at which three quarters of the grip are used.
constexpr double kSlipScale = 0.06;
/// Below it, slip is counted against this speed: no division by nothing at the start.
constexpr double kLeastSlipSpeed_mps = 0.3;
constexpr double kLeastRatioSpeed_mps = 0.05;

}  // namespace

void SimWheel::steer_to(double wanted_mps, double dt_s) {
  const double most = kSetPointAcceleration_mps2 * dt_s;
  set_point_mps_ += std::clamp(wanted_mps - set_point_mps_, -most, most);
}

double SimWheel::turn(double ground_mps, double grip_n, double dt_s) {
  const double scale_mps = std::max({std::abs(speed_mps_), std::abs(ground_mps), kLeastSlipSpeed_mps});
  const double traction_n = grip_n * std::tanh((speed_mps_ - ground_mps) / scale_mps / kSlipScale);
  const double error_mps = set_point_mps_ - speed_mps_;
  integral_n_ = std::clamp(integral_n_ + kIntegral_npm * error_mps * dt_s, -kMotorLimit_n, kMotorLimit_n);
  motor_n_ = std::clamp(kProportional_npmps * error_mps + integral_n_, -kMotorLimit_n, kMotorLimit_n);
  const double bearings_n = kBearings_n * std::tanh(speed_mps_ / kStandstill_mps);
  speed_mps_ += (motor_n_ - traction_n - bearings_n) / kInertia_kg * dt_s;
  way_m_ += speed_mps_ * dt_s;
  const double against_mps = std::max(std::abs(speed_mps_), kLeastRatioSpeed_mps);
  slip_ratio_ = std::copysign(1.0, speed_mps_) * (speed_mps_ - ground_mps) / against_mps;
  return traction_n;
}

}  // namespace hindsight
