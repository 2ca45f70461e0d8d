// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/frame_pool.h"
#include "drivers/tick_input.h"
#include "sim_replay/log_stream.h"
#include "sim_replay/run_header.h"
#include "sim_replay/tick_stream.h"

namespace hindsight {

struct ReplayOptions {
  bool recover = false;                  ///< skip what is damaged instead of ending with an error
  Time tick_period = from_seconds(0.1);  ///< of synthesised ticks, for logs that have none
};

/// A run log as a source of ticks. A log with tick events gives exactly those ticks. One without gives a tick
/// every period from its first sample on, each with the newest frame and all other samples up to its time;
/// reflex and timing of those are left for the caller to fill. Without `recover`, damage throws FatalError 65
/// naming file and byte offset, from the constructor or next(). One thread.
class ReplaySource {
 public:
  /// `pool` must outlive the source. Throws FatalError 66 (no file), 65 (not an LCM event log;
  /// none of our samples in it; damaged).
  ReplaySource(const std::filesystem::path& path, FramePool& pool, DecodeFrame decode,
               ReplayOptions options = {});
  ReplaySource(const ReplaySource&) = delete;
  ReplaySource& operator=(const ReplaySource&) = delete;

  /// The next tick, and with `published` what it published in the recorded run. False at the end. Throws
  /// FatalError 65 on damage, 70 where the pool has no free frame.
  bool next(TickInput& tick, std::vector<PublishedEvent>* published = nullptr) {
    return ticks_->next(tick, published);
  }

  bool recorded_ticks() const { return recorded_; }
  const std::optional<RunHeader>& header() const { return header_; }
  const ReplayLosses& losses() const { return stream_.losses(); }
  double progress() const { return stream_.progress(); }  ///< read so far, 0 to 1

 private:
  void read_up_to_first_sample();

  LogStream stream_;
  std::optional<RunHeader> header_;
  bool recorded_ = false;
  std::unique_ptr<TickStream> ticks_;
};

}  // namespace hindsight
