// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Wheel slip as it is defined: the wheel rolls farther than the vehicle goes.
#pragma once

#include <array>
#include <optional>

#include "config/params.h"
#include "perception/ground_odometry.h"
#include "perception/slip_detector.h"
#include "perception/wheel_way.h"

namespace hindsight {

struct GroundSlipParams {
  bool enabled = true;
  double allowed_slip = 0.2;
  double lost_way_m = 0.15;
  double min_speed_mps = 0.1;

  void visit(auto&& param) {
    param("enabled", enabled, YesNo{},
          "tell slip by the ground's flow while it is seen; otherwise by motor currents alone");
    param("allowed_slip", allowed_slip, Range{0.0, 0.9},
          "share of a wheel's way that may be lost: tyres always slip a little, ground is not quite flat");
    param("lost_way_m", lost_way_m, Range{0.005, 2.0}, "way lost beyond that share that means slip [m]");
    param("min_speed_mps", min_speed_mps, Range{0.0, 5.0},
          "the wheel must be told, and seen, to turn so fast [m/s]");
  }
};

struct WheelLoss {
  bool slipping = false;
  double lost_way_m = 0.0;  ///< beyond what is allowed; 0 to twice what means slip
  double wheel_mps = 0.0;   ///< between the last two frames: of the wheel, and of the ground under it
  double ground_mps = 0.0;
};

struct GroundSlipReport {
  bool known = false;  ///< the ground was seen lately; false: what wheels say has no meaning
  std::array<WheelLoss, kWheelCount> wheels;
};

/// Sums up, wheel by wheel, what of its way the vehicle did not go, less the share allowed, never below zero:
/// a cumulative sum test (Page 1954). Slip begins where the sum exceeds lost_way_m and ends where it is zero
/// again or the wheel stops. Errors of the ground's way that cancel out over time, as those of a pitching
/// chassis do, do not add up in it. Deterministic, no allocation, one thread at a time.
class GroundSlip {
 public:
  GroundSlip(const GroundSlipParams& params, double track_width_m)
      : params_(params), half_track_m_(0.5 * track_width_m) {}

  /// Forward positive, in the order of time; up to a frame's time before the frame's step is added.
  void add_speeds(Time stamp, double left_mps, double right_mps) { way_.add(stamp, {left_mps, right_mps}); }
  void add_step(const GroundStep& step);
  const GroundSlipReport& update(Time now, const std::array<WheelMotion, kWheelCount>& motion);

  const GroundSlipReport& report() const { return report_; }

 private:
  void add_up(WheelLoss& wheel, double rolled_m, double went_m, double dt_s);

  GroundSlipParams params_;
  double half_track_m_;
  WheelWay way_;
  std::optional<Time> last_seen_;
  GroundSlipReport report_;
};

}  // namespace hindsight
