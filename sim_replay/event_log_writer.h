// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "sim_replay/event_block.h"

namespace hindsight {

/// Writes the standard LCM event log (what lcm-logger writes and lcm-logplayer plays): for each event, all
/// numbers big-endian, the word 0xEDA1DA01, event number i64, time [us] i64, lengths of channel and data i32,
/// channel, data. Events gather in memory until flush(), which writes them at once. After a failed write the
/// file is cut back to the last whole flush, the writer stays in its error state and takes nothing more. No
/// exceptions after construction, no allocation once the buffer has grown to the largest flush. One thread.
class EventLogWriter : public EventSink {
 public:
  /// Creates or replaces the file. Throws FatalError 74 where that fails.
  explicit EventLogWriter(const std::filesystem::path& path);
  ~EventLogWriter() override;
  EventLogWriter(const EventLogWriter&) = delete;
  EventLogWriter& operator=(const EventLogWriter&) = delete;

  /// Adds an event with `size` bytes of data and returns them for the caller to fill before the next call;
  /// empty in the error state or where channel or data are longer than the reader takes (event_log_format.h).
  std::span<std::uint8_t> append(std::string_view channel, std::int64_t time_us, std::size_t size) override;
  /// Adds events that are encoded already (EventBlock), and hands them on at once. False in the error state.
  bool append_whole(std::span<const std::uint8_t> events);

  /// Hands all events so far to the operating system. False in the error state.
  bool flush();
  /// Flushes, waits for the disk if that is asked for, and closes. False if anything was lost.
  bool close(bool wait_for_disk = true);

  bool ok() const { return error_code_ == 0; }
  int error_code() const { return error_code_; }  ///< errno of the failure, 0 if none
  std::uint64_t bytes_written() const { return flushed_bytes_; }

 private:
  void fail(int error_code);

  int descriptor_ = -1;
  int error_code_ = 0;
  std::uint64_t flushed_bytes_ = 0;
  EventBlock block_;
};

}  // namespace hindsight
