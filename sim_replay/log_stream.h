// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <hindsight/gap_t.hpp>
#include <hindsight/raw_can_t.hpp>
#include <hindsight/raw_frame_t.hpp>
#include <hindsight/tick_t.hpp>
#include <string_view>
#include <vector>

#include "drivers/frame_pool.h"
#include "drivers/tick_input.h"
#include "sim_replay/run_header.h"
#include "sim_replay/run_log_reader.h"

namespace hindsight {

/// Fills frame.bgr from frame.bytes; false where the bytes are no picture of the frame's size.
using DecodeFrame = std::function<bool(Frame&)>;

/// What a replay lost, and where.
struct ReplayLosses {
  std::vector<LogDamage> damage;     ///< the first 100 damaged places
  std::uint64_t damaged_places = 0;  ///< all of them
  std::uint64_t incomplete_ticks =
      0;  ///< recorded, but not handed out because something of theirs is damaged
  std::uint64_t unrecorded_ticks = 0;   ///< that the recorder could not write
  std::uint64_t superseded_frames = 0;  ///< frames of which a synthesised tick saw only a newer one
};

/// What an event of a run log is. `published` is every channel that is not ours.
enum class LogItem { end, header, sample, tick, gap, published };

/// What a TickInput does not tell of the samples that were read into it.
struct SampleNotes {
  int frames = 0;
  int reflexes = 0;
  int timings = 0;
  std::uint64_t frame_offset = 0;  ///< of the last frame's event
};

/// The events of a run log by what they are, their contents checked. Damage throws FatalError 65 with file
/// and byte offset or, recovering, is counted and skipped. One thread.
class LogStream {
 public:
  /// `pool` must outlive the stream. Throws what RunLogReader does.
  LogStream(const std::filesystem::path& path, FramePool& pool, DecodeFrame decode, bool recover);

  /// Goes to the next event, or stays at this one if it is held.
  LogItem next();
  void hold() { held_ = true; }
  const LogEvent& event() const { return reader_.event(); }

  /// The present event's contents; false where they are damaged. A sample is added to `to`; a frame takes the
  /// place of the one there. Throws FatalError 70 where the pool has no free frame.
  bool read_sample(TickInput& to, SampleNotes& notes);
  bool read_tick(tick_t& tick);
  bool read_gap(gap_t& gap);
  bool read_header(RunHeader& header);

  /// Fills bgr of the frame that `notes` tell of.
  bool decode_picture(FrameRef& frame, const SampleNotes& notes);

  /// For what follows from damage elsewhere: throws FatalError 65, or returns if recovering.
  void refuse(std::uint64_t offset, std::string_view reason) const;
  /// Throws FatalError 65 or, recovering, counts.
  void note_damage(std::uint64_t offset, std::string_view reason);

  ReplayLosses& losses() { return losses_; }
  const ReplayLosses& losses() const { return losses_; }
  double progress() const;
  std::uint64_t size() const { return reader_.size(); }
  const std::string& path() const { return reader_.path(); }

 private:
  const char* decode_frame(FrameRef& frame);
  bool sound(const char* reason);

  RunLogReader reader_;
  FramePool& pool_;
  DecodeFrame decode_;
  bool recover_ = false;
  bool held_ = false;
  LogItem item_ = LogItem::end;
  ReplayLosses losses_;
  raw_frame_t frame_message_{};  ///< reused, so that their vectors are
  raw_can_t can_message_{};
};

}  // namespace hindsight
