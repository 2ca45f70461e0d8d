// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>

#include "perception/ground_slip.h"
#include "perception/slip_detector.h"

namespace hindsight {

/// Whether the wheels slip, by all that there is to know: by the ground while it is seen, which tells slip
/// itself; else by the motor currents. One thread at a time, no allocation after construction.
class SlipWatch {
 public:
  /// As SlipDetector and GroundSlip.
  SlipWatch(const SlipDetectorParams& currents, double current_rate_hz, const GroundSlipParams& ground,
            double track_width_m)
      : currents_(currents, current_rate_hz), ground_(ground, track_width_m) {}

  void add_currents(Time stamp, double left_a, double right_a);
  void add_speeds(Time stamp, double left_mps, double right_mps) {
    ground_.add_speeds(stamp, left_mps, right_mps);
  }
  void add_step(const GroundStep& step) { ground_.add_step(step); }
  /// Call after the samples up to `now`. Returns whether either wheel slips.
  bool update(Time now, const std::array<WheelMotion, kWheelCount>& motion);

  bool slipping(Wheel wheel) const { return slipping_[static_cast<std::size_t>(wheel)]; }
  bool slipping() const { return slipping_[0] || slipping_[1]; }
  const SlipDetector& currents() const { return currents_; }
  const GroundSlipReport& ground() const { return ground_.report(); }

 private:
  SlipDetector currents_;
  GroundSlip ground_;
  std::array<bool, kWheelCount> slipping_{};
};

}  // namespace hindsight
