// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include "sim_replay/log_messages.h"
#include "sim_replay/tick_stream.h"

namespace hindsight {
namespace {

bool has_all_samples(const tick_t& recorded, const TickInput& tick, const SampleNotes& notes) {
  const auto as_recorded = [](const auto& samples, std::int32_t count) {
    return static_cast<std::int64_t>(samples.size()) == count;
  };
  return notes.frames == recorded.frames && notes.reflexes == 1 && notes.timings == 1 &&
         as_recorded(tick.can, recorded.can_frames) && as_recorded(tick.edges, recorded.line_edges) &&
         as_recorded(tick.fixes, recorded.fixes) && as_recorded(tick.commands, recorded.commands) &&
         as_recorded(tick.reports, recorded.reports);
}

}  // namespace

bool RecordedTicks::next(TickInput& tick, std::vector<PublishedEvent>* published) {
  begin(tick);
  for (;;) {
    switch (stream_.next()) {
      case LogItem::sample:
        begun_ = true;
        stream_.read_sample(tick, notes_);  // a damaged one leaves the tick incomplete
        break;
      case LogItem::tick:
        if (!finish(tick)) {
          begin(tick);
          break;
        }
        if (published != nullptr) read_published(*published);
        return true;
      case LogItem::gap:
        skip_gap();
        break;
      case LogItem::header:
        stream_.note_damage(stream_.event().offset, "a run header within the run");
        break;
      case LogItem::published:  // nobody asked for it, or its tick is not handed out
        break;
      case LogItem::end:
        expect_no_rest();
        return false;
    }
  }
}

void RecordedTicks::begin(TickInput& tick) {
  tick.clear();
  tick.reflex = {};
  tick.timing = {};
  notes_ = {};
}

bool RecordedTicks::finish(TickInput& tick) {
  const std::uint64_t offset = stream_.event().offset;
  tick_t recorded{};
  if (!stream_.read_tick(recorded)) return false;
  begun_ = false;
  if (recorded.index < next_index_) {
    stream_.note_damage(offset, fmt::format("tick {} where {} was expected", recorded.index, next_index_));
    return false;
  }
  const std::int64_t missing = recorded.index - next_index_;
  if (missing > 0)
    stream_.refuse(offset, fmt::format("tick {} where {} was expected", recorded.index, next_index_));
  stream_.losses().incomplete_ticks += static_cast<std::uint64_t>(missing);
  next_index_ = recorded.index + 1;
  const bool whole = has_all_samples(recorded, tick, notes_);
  if (!whole) stream_.refuse(offset, fmt::format("tick {} lacks samples that it saw", recorded.index));
  if (!whole || !stream_.decode_picture(tick.frame, notes_)) {
    ++stream_.losses().incomplete_ticks;
    return false;
  }
  return from_message(recorded, tick);
}

void RecordedTicks::read_published(std::vector<PublishedEvent>& published) {
  published.clear();
  while (stream_.next() == LogItem::published) {
    const LogEvent& event = stream_.event();
    published.push_back({std::string(event.channel), event.time_us, {event.data.begin(), event.data.end()}});
  }
  stream_.hold();
}

void RecordedTicks::skip_gap() {
  gap_t gap{};
  if (!stream_.read_gap(gap) || gap.first_index < next_index_) return;
  stream_.losses().incomplete_ticks += static_cast<std::uint64_t>(gap.first_index - next_index_);
  stream_.losses().unrecorded_ticks += static_cast<std::uint64_t>(gap.ticks);
  next_index_ = gap.first_index + gap.ticks;
}

void RecordedTicks::expect_no_rest() {
  if (!begun_) return;
  stream_.refuse(stream_.size(), "the log ends within a tick");
  ++stream_.losses().incomplete_ticks;
}

}  // namespace hindsight
