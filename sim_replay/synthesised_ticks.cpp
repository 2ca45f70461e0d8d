// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "sim_replay/tick_stream.h"

namespace hindsight {
namespace {

/// A longer silence is a wrong stamp, not a recording.
constexpr Time kLongestGap = std::chrono::hours(1);
constexpr Time kLastStamp{std::int64_t{1} << 61};

/// Of an event's time: nothing that is reckoned with it then overflows.
bool is_unix_time(std::int64_t utime_us) { return utime_us >= 0 && utime_us <= kLastStamp.count(); }

/// Calls f(list of a, list of b) for each kind of sample that comes in lists.
template <class Function>
void for_each_list(TickInput& a, TickInput& b, Function f) {
  f(a.can, b.can);
  f(a.edges, b.edges);
  f(a.fixes, b.fixes);
  f(a.commands, b.commands);
  f(a.reports, b.reports);
}

bool is_empty(const TickInput& samples) {
  return !samples.frame && samples.can.empty() && samples.edges.empty() && samples.fixes.empty() &&
         samples.commands.empty() && samples.reports.empty();
}

/// Earliest and latest stamp; {max, min} of Time where there is no sample.
std::pair<Time, Time> stamp_span(TickInput& samples) {
  std::pair<Time, Time> span{Time::max(), Time::min()};
  const auto widen = [&span](Time stamp) {
    span = {std::min(span.first, stamp), std::max(span.second, stamp)};
  };
  if (samples.frame) widen(samples.frame->stamp);
  for_each_list(samples, samples, [&widen](const auto& list, const auto&) {
    for (const auto& sample : list) widen(sample.stamp);
  });
  return span;
}

}  // namespace

bool SynthesisedTicks::next(TickInput& tick, std::vector<PublishedEvent>* published) {
  if (published != nullptr) published->clear();
  tick.clear();
  due_notes_ = {};
  if (is_empty(ahead_) && !read_ahead()) return false;
  take_due(tick);
  while (event_stamp_ <= *now_ && read_ahead()) take_due(tick);
  if (!stream_.decode_picture(tick.frame, due_notes_)) tick.frame = {};
  tick.index = index_++;
  tick.now = *now_;
  tick.utime_us = now_->count() / 1000 + utime_offset_us_;
  *now_ += period_;
  return true;
}

/// Adds the next event that holds samples to `ahead_`; false at the end of the log.
bool SynthesisedTicks::read_ahead() {
  for (;;) {
    event_.clear();
    const LogItem item = stream_.next();
    if (item == LogItem::end) return false;
    if (item != LogItem::sample || !stream_.read_sample(event_, ahead_notes_) || is_empty(event_)) continue;
    const auto [first, last] = stamp_span(event_);
    if (first < Time::zero() || last > kLastStamp || (now_ && last > *now_ + kLongestGap)) {
      stream_.note_damage(stream_.event().offset, "a sample's stamp is out of order by more than an hour");
      continue;
    }
    if (!now_ && !is_unix_time(stream_.event().time_us)) {
      stream_.note_damage(stream_.event().offset, "an event's time is none since 1970");
      continue;
    }
    if (!now_) utime_offset_us_ = stream_.event().time_us - first.count() / 1000;
    if (!now_) now_ = first;
    event_stamp_ = first;
    if (event_.frame) ahead_.frame = std::move(event_.frame);
    for_each_list(event_, ahead_,
                  [](auto& from, auto& to) { to.insert(to.end(), from.begin(), from.end()); });
    return true;
  }
}

/// Moves what is not younger than the tick from `ahead_` to the tick.
void SynthesisedTicks::take_due(TickInput& tick) {
  for_each_list(ahead_, tick, [this](auto& from, auto& to) {
    const auto is_due = [this](const auto& sample) { return sample.stamp <= *now_; };
    std::copy_if(from.begin(), from.end(), std::back_inserter(to), is_due);
    std::erase_if(from, is_due);
  });
  if (!ahead_.frame || ahead_.frame->stamp > *now_) return;
  if (tick.frame) ++stream_.losses().superseded_frames;
  if (!tick.frame || ahead_.frame->stamp >= tick.frame->stamp) {
    tick.frame = ahead_.frame;
    due_notes_ = ahead_notes_;
  }
  ahead_.frame = {};
}

}  // namespace hindsight
