// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Whether the vehicle may move, as a pure state machine of the loop. Every stop is latched: the way out is always an
// operator's "arm", and that is refused while its cause lasts.
//
//   state     event                                     next      reason
//   -------   ---------------------------------------   -------   -----------------------------------------
//   any       e-stop line active                        stopped   estop (needs release_estop before arm)
//   any       operator stop                             stopped   operator_stop
//   armed     operator disarm                           stopped   not_armed
//   armed     a required source is not fresh            stopped   gpio, can_bus, wheels, camera (in that order)
//   armed     more than max_overruns late ticks a row   stopped   overruns
//   stopped   operator arm and no cause lasts           armed     none
//   stopped   operator arm while a cause lasts          stopped   that cause
//
// The first rule that applies wins; the table's order is the priority.
#pragma once

#include <array>
#include <span>

#include "config/params.h"
#include "daemon/stop_reason.h"
#include "drivers/samples.h"

namespace hindsight {

struct FailsafeParams {
  double camera_timeout_s = 0.3;
  double wheels_timeout_s = 0.15;
  int max_overruns = 5;
  bool arm_at_start = false;

  void visit(auto&& param) {
    param("camera_timeout_s", camera_timeout_s, Range{0.05, 5.0}, "a frame older than this is stale [s]");
    param("wheels_timeout_s", wheels_timeout_s, Range{0.02, 5.0}, "an encoder sample older than this is stale [s]");
    param("max_overruns", max_overruns, Range{1, 1000}, "late ticks in a row that stop the vehicle");
    param("arm_at_start", arm_at_start, YesNo{},
          "arm by itself once, as soon as every required source is fresh; else an operator arms");
  }
};

/// What the machine judges in one tick.
struct FailsafeInput {
  std::array<SourceState, kSourceCount> sources{};
  bool wheels_fresh = false;
  bool estop_active = false;
  bool overrun = false;  ///< the previous tick was late
  std::span<const OperatorCommand> commands;
};

class Failsafe {
 public:
  explicit Failsafe(const FailsafeParams& params);

  /// Returns none where motion is permitted.
  StopReason step(const FailsafeInput& input);
  bool armed() const { return armed_; }

 private:
  StopReason lasting_cause(const FailsafeInput& input) const;
  void stop(StopReason reason);
  void obey(const OperatorCommand& command, StopReason cause, bool estop_active);

  FailsafeParams params_;
  bool armed_ = false;
  bool estop_latched_ = false;
  bool arm_pending_;
  int overruns_in_a_row_ = 0;
  StopReason reason_ = StopReason::not_armed;
};

}  // namespace hindsight
