// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/command_gate.h"

#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

/// A tick's worth at most: after a pause the slew limit must not have grown without bound.
constexpr double kLongestStep_s = 0.1;

bool drives_forward(const DriveCommand& command) { return command.left_mps > 0.0 || command.right_mps > 0.0; }

}  // namespace

CommandGate::CommandGate(const GateParams& params, const VehicleParams& vehicle)
    : params_(params), vehicle_(vehicle) {}

StopReason CommandGate::verdict(const GateInput& input) const {
  if (input.estop_active || input.decided_at < input.last_estop_edge) return StopReason::estop;
  if (input.loop_reason != StopReason::none) return input.loop_reason;
  if (!input.lines_ok) return StopReason::gpio;
  if (!input.bus_ok) return StopReason::can_bus;
  if (input.now - input.decided_at > from_seconds(params_.command_timeout_s)) return StopReason::stale_command;
  if (!std::isfinite(input.wanted.left_mps) || !std::isfinite(input.wanted.right_mps)) return StopReason::bad_command;
  if (input.decided_at < input.last_bumper_edge) return StopReason::bumper;
  if (input.bumper_active && drives_forward(input.wanted)) return StopReason::bumper;
  return StopReason::none;
}

double CommandGate::limited(double wanted_mps, double last_mps, double dt_s) const {
  const double speed = std::clamp(wanted_mps, -vehicle_.max_speed_mps, vehicle_.max_speed_mps);
  const double step = vehicle_.max_acceleration_mps2 * dt_s;
  // Only speeding up is limited: slowing down towards zero is never held back.
  const double low = last_mps > 0.0 ? 0.0 : last_mps - step;
  const double high = last_mps < 0.0 ? 0.0 : last_mps + step;
  return std::clamp(speed, low, high);
}

GateOutput CommandGate::step(const GateInput& input) {
  const double dt_s = std::clamp(to_seconds(input.now - last_time_), 0.0, kLongestStep_s);
  last_time_ = input.now;
  const StopReason reason = verdict(input);
  last_ = reason == StopReason::none ? DriveCommand{limited(input.wanted.left_mps, last_.left_mps, dt_s),
                                                    limited(input.wanted.right_mps, last_.right_mps, dt_s)}
                                     : DriveCommand{};
  return {last_, reason};
}

}  // namespace hindsight
