// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// How well slip is told: what is sensed in a drive with the truth beside it, and what a SlipWatch makes of
// it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "perception/slip_watch.h"
#include "sim_replay/world/world.h"
#include "tools/motor_csv.h"

namespace hindsight::tools {

/// When wheels slipped. Turns of grip shorter than SlipTrace::kJoin do not end a slip.
struct SlipSpan {
  Time begin{};
  Time end{};
};

/// How slip is told.
struct SlipWatchParams {
  SlipDetectorParams currents;
  GroundSlipParams ground;
};

/// What is sensed in a drive, and the truth. Times ascend.
struct SlipTrace {
  static constexpr Time kJoin = from_seconds(0.5);
  /// So long after a slip, what a detector says is about that slip, whatever its window.
  static constexpr Time kAftermath = from_seconds(4.0);

  struct Currents {
    Time stamp{};
    double left_a = 0.0;
    double right_a = 0.0;
  };
  struct Speeds {
    Time stamp{};
    double left_mps = 0.0;
    double right_mps = 0.0;
  };
  struct Tick {
    Time now{};
    std::array<WheelMotion, kWheelCount> motion;
    BodyPose X_WB{};  ///< truth
  };
  Time begin{};
  std::vector<Currents> currents{};
  std::vector<Speeds> speeds{};
  std::vector<GroundStep> steps{};  ///< between ticks next to each other, where somebody looked
  std::vector<Tick> ticks{};        ///< when slip is asked for
  std::vector<SlipSpan> slips{};

  /// The truth at `now`; call in the order of time.
  void see_truth(Time now, bool slipping);
  /// Slips that begin in quiet: what was before is forgotten.
  std::vector<SlipSpan> fresh_slips() const;
};

/// What became of one slip.
struct SlipOutcome {
  double lasted_s = 0.0;
  double delay_s = 0.0;  ///< until it was told; infinite where it was not before its aftermath ended
};

struct SlipScore {
  std::vector<SlipOutcome> slips;  ///< that began after quiet; not those in another's aftermath
  int false_alarms = 0;            ///< beginnings of slip in quiet time
  double quiet_h = 0.0;            ///< without slip or its aftermath

  /// Of the slips that lasted so long: the share told until then. 0 where none did.
  double share_told_within(double seconds) const;
  int lasted(double seconds) const;
  /// Of the slips that lasted so long, `part` had been told after what this returns; infinite where they
  /// never were.
  double delay_s(double part, double lasted_s) const;
  double false_alarms_per_hour() const { return quiet_h > 0.0 ? false_alarms / quiet_h : 0.0; }
};

/// Adds what is told of a drive. `current_rate_hz` and `track_width_m` as RobotParams and VehicleParams have
/// them.
void score_slip(const SlipWatchParams& params, double current_rate_hz, double track_width_m,
                const SlipTrace& trace, SlipScore& score);

/// Rising edges of the slip state over a recording of `rate_hz`, which begins without slip. Recordings hold
/// no commands: a wheel that turns was told to; one of unknown speed is taken to turn.
int count_detections(const MotorRecording& recording, double rate_hz, const SlipDetectorParams& params);

}  // namespace hindsight::tools
