// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drivers/tick_input.h"
#include "sim_replay/log_stream.h"

namespace hindsight {

/// One message that a recorded tick published.
struct PublishedEvent {
  std::string channel;
  std::int64_t utime_us = 0;
  std::vector<std::uint8_t> bytes;
};

/// Ticks out of the events of a log (replay_source.h).
class TickStream {
 public:
  virtual ~TickStream() = default;
  virtual bool next(TickInput& tick, std::vector<PublishedEvent>* published) = 0;
};

/// Exactly the ticks that were recorded. One of which a sample is missing or damaged is not handed out.
class RecordedTicks : public TickStream {
 public:
  explicit RecordedTicks(LogStream& stream) : stream_(stream) {}
  bool next(TickInput& tick, std::vector<PublishedEvent>* published) override;

 private:
  void begin(TickInput& tick);
  bool finish(TickInput& tick);
  void read_published(std::vector<PublishedEvent>& published);
  void skip_gap();
  void expect_no_rest();

  LogStream& stream_;
  SampleNotes notes_;
  bool begun_ = false;  ///< samples were read that no tick event has claimed yet
  std::int64_t next_index_ = 0;
};

/// A tick every period from the first sample on, for a log that has samples only.
class SynthesisedTicks : public TickStream {
 public:
  SynthesisedTicks(LogStream& stream, Time period) : stream_(stream), period_(period) {}
  bool next(TickInput& tick, std::vector<PublishedEvent>* published) override;

 private:
  bool read_ahead();
  void take_due(TickInput& tick);

  LogStream& stream_;
  Time period_;
  TickInput ahead_;     ///< read, but younger than the last tick; reading stops at the first event that is
  TickInput event_;     ///< the samples of the event read last
  Time event_stamp_{};  ///< its earliest
  SampleNotes ahead_notes_;
  SampleNotes due_notes_;
  std::optional<Time> now_;  ///< of the next tick
  std::int64_t utime_offset_us_ = 0;
  std::uint64_t index_ = 0;
};

}  // namespace hindsight
