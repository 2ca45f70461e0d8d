// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "drivers/tick_input.h"
#include "sim_replay/event_sink.h"
#include "sim_replay/run_header.h"

namespace hindsight {

struct LogMessages;

/// Turns a run into the events of its log: header, then for each tick its samples, its tick event and what it
/// published. A tick that does not follow the one before by one leaves a gap event. All writers return false
/// where the sink takes nothing. No allocation once buffers have grown. One thread.
class RunLogEncoder {
 public:
  explicit RunLogEncoder(EventSink& sink);
  ~RunLogEncoder();

  bool write_header(const RunHeader& header);
  /// Samples in the order of TickInput, each at the tick's utime_us, then the tick event.
  bool write_tick(const TickInput& tick);
  bool write_published(std::string_view channel, std::int64_t utime_us, std::span<const std::uint8_t> bytes);

  /// Single samples for a log without ticks; in the order of their stamps. `utime_us` is the event's time.
  bool write_frame(const Frame& frame, std::int64_t utime_us);
  bool write_can(std::span<const CanFrame> frames, std::int64_t utime_us);
  bool write_edge(const LineEdge& edge, std::int64_t utime_us);
  bool write_fix(const GpsFix& fix, std::int64_t utime_us);
  bool write_command(const OperatorCommand& command, std::int64_t utime_us);
  /// Ticks from index `from` up to before `to` are not in the log.
  bool write_gap(std::uint64_t from, std::uint64_t to, std::int64_t utime_us);

 private:
  void write_gap_before(const TickInput& tick);

  EventSink& sink_;
  std::unique_ptr<LogMessages> messages_;  ///< reused, so that their vectors are
  std::uint64_t next_index_ = 0;
};

}  // namespace hindsight
