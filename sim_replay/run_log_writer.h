// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>

#include "sim_replay/event_log_writer.h"
#include "sim_replay/run_log_encoder.h"

namespace hindsight {

/// A run log as a file. Call flush() after each tick's published messages, so that a log cut off by a crash
/// ends with a whole tick. In the error state (disk full, ...) nothing more is recorded. One thread.
class RunLogWriter : public RunLogEncoder {
 public:
  /// Creates or replaces the file. Throws FatalError 74 where that fails.
  explicit RunLogWriter(const std::filesystem::path& path) : RunLogEncoder(log_), log_(path) {}

  /// Adds events that are encoded already.
  bool write_whole(std::span<const std::uint8_t> events) { return log_.append_whole(events); }
  bool flush() { return log_.flush(); }
  bool close(bool wait_for_disk = true) { return log_.close(wait_for_disk); }
  bool ok() const { return log_.ok(); }
  int error_code() const { return log_.error_code(); }  ///< errno of the failure, 0 if none
  std::uint64_t bytes_written() const { return log_.bytes_written(); }

 private:
  EventLogWriter log_;
};

}  // namespace hindsight
