// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/ground_slip.h"

#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

constexpr Time kLately = from_seconds(0.5);

}  // namespace

void GroundSlip::add_step(const GroundStep& step) {
  if (!params_.enabled || !step.motion.valid || step.to <= step.from) return;
  const auto rolled_m = way_.between(step.from, step.to);
  if (!rolled_m) return;
  last_seen_ = step.to;
  const double dt_s = to_seconds(step.to - step.from), aside_m = half_track_m_ * step.motion.turn_rad;
  const WheelWay::Wheels went_m{step.motion.forward_m - aside_m, step.motion.forward_m + aside_m};
  for (std::size_t i = 0; i < kWheelCount; ++i) add_up(report_.wheels[i], (*rolled_m)[i], went_m[i], dt_s);
}

void GroundSlip::add_up(WheelLoss& wheel, double rolled_m, double went_m, double dt_s) {
  wheel.wheel_mps = rolled_m / dt_s;
  wheel.ground_mps = went_m / dt_s;
  // What goes against the wheel is lost, too.
  const double lost_m = std::abs(rolled_m) - std::copysign(1.0, rolled_m) * went_m;
  wheel.lost_way_m = std::clamp(wheel.lost_way_m + lost_m - params_.allowed_slip * std::abs(rolled_m), 0.0,
                                2.0 * params_.lost_way_m);
}

const GroundSlipReport& GroundSlip::update(Time now, const std::array<WheelMotion, kWheelCount>& motion) {
  report_.known = last_seen_ && now - *last_seen_ <= kLately;
  for (std::size_t i = 0; i < kWheelCount; ++i) {
    WheelLoss& wheel = report_.wheels[i];
    if (!report_.known || !turns(motion[i], params_.min_speed_mps)) wheel.lost_way_m = 0.0;
    wheel.slipping = wheel.lost_way_m > (wheel.slipping ? 0.0 : params_.lost_way_m);
  }
  return report_;
}

}  // namespace hindsight
