// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "sim_replay/vehicle/sim_wheel.h"
#include "sim_replay/world/random.h"

namespace hindsight {

/// The current that the base tells of one motor: load, its unsteadiness, and the swing of the motor
/// controller near 3 Hz while the wheel slips (thesis 5, figure 5.5).
class MotorCurrent {
 public:
  explicit MotorCurrent(Random random) : random_(random) {}

  /// After `dt_s` with the wheel as it is.
  void step(const SimWheel& wheel, bool slipping, double dt_s);
  double current_a() const { return current_a_; }

 private:
  void disturb(double dt_s);
  void swing(bool slipping, double dt_s);

  Random random_;
  double current_a_ = 0.0;
  double floor_ = 0.0;
  double hump_ = 0.0;
  double hump_rate_ = 0.0;
  double swing_part_ = 0.0;  ///< 0 no swing, 1 all of it
  double swing_amplitude_ = 0.0;
  double swing_detuning_hz_ = 0.0;
  double swing_phase_rad_ = 0.0;
};

}  // namespace hindsight
