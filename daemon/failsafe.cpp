// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/failsafe.h"

namespace hindsight {

Failsafe::Failsafe(const FailsafeParams& params) : params_(params), arm_pending_(params.arm_at_start) {}

StopReason Failsafe::lasting_cause(const FailsafeInput& input) const {
  const auto fresh = [&](Source source) {
    return input.sources[static_cast<std::size_t>(source)] == SourceState::fresh;
  };
  if (estop_latched_) return StopReason::estop;
  if (!fresh(Source::gpio)) return StopReason::gpio;
  if (!fresh(Source::can)) return StopReason::can_bus;
  if (!input.wheels_fresh) return StopReason::wheels;
  if (!fresh(Source::camera)) return StopReason::camera;
  if (input.gps_lost) return StopReason::gps;
  if (input.bumper_left_stuck) return StopReason::bumper_left_stuck;
  if (input.bumper_right_stuck) return StopReason::bumper_right_stuck;
  if (overruns_in_a_row_ > params_.max_overruns) return StopReason::overruns;
  return StopReason::none;
}

/// What the reflex saw between two ticks may be gone by now; it is latched all the same.
StopReason Failsafe::cause_to_stop(const FailsafeInput& input) const {
  const StopReason lasting = lasting_cause(input);
  if (lasting != StopReason::none) return lasting;
  const bool lost = input.reflex_reason == StopReason::gpio || input.reflex_reason == StopReason::can_bus;
  return lost ? input.reflex_reason : StopReason::none;
}

void Failsafe::stop(StopReason reason) {
  armed_ = false;
  arm_pending_ = false;
  reason_ = estop_latched_ ? StopReason::estop : reason;
}

void Failsafe::obey(const OperatorCommand& command, StopReason cause, bool estop_active) {
  switch (command.kind) {
    case CommandKind::stop:
      stop(StopReason::operator_stop);
      break;
    case CommandKind::disarm:
      arm_pending_ = false;
      if (armed_) stop(StopReason::not_armed);
      break;
    case CommandKind::release_estop:
      if (estop_latched_ && !estop_active) {
        estop_latched_ = false;
        reason_ = StopReason::not_armed;
      }
      break;
    case CommandKind::arm:
      armed_ = cause == StopReason::none;
      reason_ = cause;
      break;
    case CommandKind::go_to_local:
    case CommandKind::go_to_global:
    case CommandKind::set_mode:
    case CommandKind::save_model:
      break;
  }
}

StopReason Failsafe::step(const FailsafeInput& input) {
  overruns_in_a_row_ = input.overrun ? overruns_in_a_row_ + 1 : 0;
  if (input.estop_active) {
    estop_latched_ = true;
    stop(StopReason::estop);
  }
  if (arm_pending_ && lasting_cause(input) == StopReason::none) {
    arm_pending_ = false;
    armed_ = true;
    reason_ = StopReason::none;
  }
  for (const OperatorCommand& command : input.commands) {
    obey(command, lasting_cause(input), input.estop_active);
  }
  if (armed_) {
    const StopReason cause = cause_to_stop(input);
    if (cause != StopReason::none) stop(cause);
  }
  return reason_;
}

}  // namespace hindsight
