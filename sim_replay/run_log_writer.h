// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

#include "drivers/tick_input.h"
#include "sim_replay/event_log_writer.h"
#include "sim_replay/run_header.h"

namespace hindsight {

struct LogMessages;

/// Writes a run log: header, then for each tick its samples, its tick event and what it published. A tick
/// that does not follow the one before by one leaves a gap event. Call flush() after each tick's published
/// messages, so that a log cut off by a crash ends with a whole tick. All writers return false in the error
/// state (disk full, ...), in which nothing more is recorded. No allocation once buffers have grown. One
/// thread.
class RunLogWriter {
 public:
  /// Creates or replaces the file. Throws FatalError 74 where that fails.
  explicit RunLogWriter(const std::filesystem::path& path);
  ~RunLogWriter();

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

  bool flush() { return log_.flush(); }
  bool close() { return log_.close(); }
  bool ok() const { return log_.ok(); }
  int error_code() const { return log_.error_code(); }  ///< errno of the failure, 0 if none
  std::uint64_t bytes_written() const { return log_.bytes_written(); }

 private:
  void write_gap_before(const TickInput& tick);

  EventLogWriter log_;
  std::unique_ptr<LogMessages> messages_;  ///< reused, so that their vectors are
  std::uint64_t next_index_ = 0;
};

}  // namespace hindsight
