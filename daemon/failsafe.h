// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Whether the vehicle may move, as a pure state machine of the loop. Every stop is latched: the way out is always an
// operator's "arm", and that is refused while its cause lasts.
//
//   state     event                                       next      reason          way out
//   -------   -----------------------------------------   -------   -------------   ---------------------------------
//   any       e-stop line active                          stopped   estop           line released, release_estop, arm
//   any       operator stop                               stopped   operator_stop   arm
//   armed     operator disarm                             stopped   not_armed       arm
//   armed     GPIO lines not fresh                        stopped   gpio            fresh again, arm
//   armed     CAN bus not fresh                           stopped   can_bus         fresh again, arm
//   armed     encoder samples not fresh                   stopped   wheels          fresh again, arm
//   armed     camera not fresh                            stopped   camera          fresh again, arm
//   armed     GPS gave a fix, but none for too long       stopped   gps             a fix, arm
//   armed     a bumper pressed ever since the start       stopped   bumper_*_stuck  bumper released, arm
//   armed     more than max_overruns late ticks a row     stopped   overruns        a tick in time, arm
//   armed     the reflex lost lines or bus since the      stopped   gpio, can_bus   arm
//             last tick, and has them again
//   stopped   release_estop of an e-stop, line inactive   stopped   not_armed       arm
//   stopped   operator arm while a cause lasts            stopped   that cause      the cause's own
//   stopped   operator arm and no cause lasts             armed     none
//   start     -                                           stopped   not_armed       arm
//   start     arm_at_start and no cause lasts             armed     none
//
// The first rule that applies wins; the table's order is the priority. Commands of one tick are obeyed one after the
// other. From an e-stop to its release the reason stays estop, whatever is asked for. Any stop and a disarm end the
// start: after them nothing arms but an operator.
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
  double gps_timeout_s = 60.0;
  int max_overruns = 5;
  bool arm_at_start = false;

  void visit(auto&& param) {
    param("camera_timeout_s", camera_timeout_s, Range{0.05, 5.0}, "a frame older than this is stale [s]");
    param("wheels_timeout_s", wheels_timeout_s, Range{0.02, 5.0}, "an encoder sample older than this is stale [s]");
    param("gps_timeout_s", gps_timeout_s, Range{1.0, 1e6},
          "how long it drives on without a fix once GPS gave one, by wheels and gyro alone [s]");
    param("max_overruns", max_overruns, Range{1, 1000}, "so many late ticks in a row are borne; one more stops");
    param("arm_at_start", arm_at_start, YesNo{},
          "arm by itself once, as soon as every required source is fresh; else an operator arms");
  }
};

/// What the machine judges in one tick.
struct FailsafeInput {
  std::array<SourceState, kSourceCount> sources{};
  bool wheels_fresh = false;
  bool estop_active = false;
  bool gps_lost = false;
  bool bumper_left_stuck = false;
  bool bumper_right_stuck = false;
  StopReason reflex_reason = StopReason::none;  ///< why the reflex stopped though the last tick permitted motion
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
  StopReason cause_to_stop(const FailsafeInput& input) const;
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
