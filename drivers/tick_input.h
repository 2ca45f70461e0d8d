// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Everything that one step of the core may know: the samples up to the tick's time. Live sources, replay and
// simulation fill it; the recorder writes it; the core reads it. Whoever owns one reserves its vectors once.
#pragma once

#include <cstdint>
#include <vector>

#include "drivers/samples.h"

namespace hindsight {

/// What the reflex did since the last tick (daemon/reflex.h), told to the core as a sample so that a replay
/// sees the same. `stop_reason` is the number of a daemon/failsafe.h reason, 0 where motion was permitted.
struct ReflexReport {
  Time stamp{};
  float left_mps = 0.0F;  ///< the last set-point that went to the bus
  float right_mps = 0.0F;
  std::uint8_t stop_reason = 0;
  std::uint32_t frames_sent = 0;  ///< CAN command frames since start
  std::uint32_t send_errors = 0;
};

/// How the previous tick went by the machine's clock: a measurement, hence an input.
struct LoopTiming {
  Time wake_latency{};                 ///< how late the previous tick began
  Time step_duration{};                ///< how long its step took
  std::uint32_t overruns = 0;          ///< ticks skipped since start because one took too long
  std::uint32_t recorder_dropped = 0;  ///< ticks that the run log lost since start
};

struct TickInput {
  std::uint64_t index = 0;    ///< 0 for the first tick of a run
  Time now{};                 ///< no sample is younger
  std::int64_t utime_us = 0;  ///< the same instant, UNIX time, for message stamps only
  FrameRef frame;             ///< the newest frame since the last tick, or empty
  std::vector<CanFrame> can;  ///< in order of arrival, as are the others
  std::vector<LineEdge> edges;
  std::vector<GpsFix> fixes;
  std::vector<OperatorCommand> commands;
  std::vector<SourceReport> reports;
  ReflexReport reflex;
  LoopTiming timing;

  void reserve() {
    can.reserve(1024);
    edges.reserve(64);
    fixes.reserve(16);
    commands.reserve(16);
    reports.reserve(32);
  }
  void clear() {
    frame = {};
    can.clear();
    edges.clear();
    fixes.clear();
    commands.clear();
    reports.clear();
  }
};

}  // namespace hindsight
