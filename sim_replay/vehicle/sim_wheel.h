// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace hindsight {

/// A driven wheel with its motor and the base's speed controller. All speeds and forces at the contact point.
class SimWheel {
 public:
  /// Moves the controller's set-point towards the wanted speed, as fast as the base lets it.
  void steer_to(double wanted_mps, double dt_s);

  /// One step on ground that goes by at `ground_mps` and bears at most `grip_n`; returns the traction on the
  /// vehicle [N].
  double turn(double ground_mps, double grip_n, double dt_s);
  /// Stops it dead, the brake on: where the vehicle stands and nothing moves it.
  void rest() { speed_mps_ = motor_n_ = integral_n_ = slip_ratio_ = 0.0; }

  double set_point_mps() const { return set_point_mps_; }
  double speed_mps() const { return speed_mps_; }
  /// Rolled since start, slip included.
  double way_m() const { return way_m_; }
  /// What the motor gives, forward positive.
  double motor_n() const { return motor_n_; }
  /// (wheel - ground) / wheel as of the last step: 0 rolls, 1 turns on the spot. Signed only by what is
  /// faster.
  double slip_ratio() const { return slip_ratio_; }

 private:
  double set_point_mps_ = 0.0;
  double speed_mps_ = 0.0;
  double way_m_ = 0.0;
  double motor_n_ = 0.0;
  double integral_n_ = 0.0;
  double slip_ratio_ = 0.0;
};

/// The strongest force of one motor: stalls on a road, turns wheels on grass where the vehicle stands at a
/// tree.
constexpr double kMotorLimit_n = 200.0;

}  // namespace hindsight
