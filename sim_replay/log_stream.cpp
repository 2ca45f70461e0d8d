// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/log_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "config/exit_code.h"
#include "sim_replay/log_channels.h"
#include "sim_replay/log_messages.h"

namespace hindsight {
namespace {

constexpr std::size_t kRememberedDamage = 100;
constexpr std::int64_t kMostTicks = std::int64_t{1} << 48;  // of a run of nine million years

LogItem item_of(std::string_view channel) {
  using namespace log_channel;
  constexpr std::array samples{kCamera, kCan, kLine, kFix, kCommand, kReport, kReflex, kTiming};
  if (std::find(samples.begin(), samples.end(), channel) != samples.end()) return LogItem::sample;
  if (channel == kTick) return LogItem::tick;
  if (channel == kGap) return LogItem::gap;
  return channel == kHeader ? LogItem::header : LogItem::published;
}

/// Decodes a Message and adds it to the samples of its kind.
template <class Message, class Sample>
const char* add_sample(std::span<const std::uint8_t> data, std::vector<Sample>& samples) {
  Message message{};
  Sample sample{};
  const char* const reason = decode_sample(data, message, sample);
  if (reason == nullptr) samples.push_back(sample);
  return reason;
}

template <class Message, class Sample>
const char* set_sample(std::span<const std::uint8_t> data, Sample& sample) {
  Message message{};
  return decode_sample(data, message, sample);
}

}  // namespace

LogStream::LogStream(const std::filesystem::path& path, FramePool& pool, DecodeFrame decode, bool recover)
    : reader_(path, recover), pool_(pool), decode_(std::move(decode)), recover_(recover) {}

LogItem LogStream::next() {
  if (std::exchange(held_, false)) return item_;
  for (;;) {
    switch (reader_.next()) {
      case RunLogReader::Result::end:
        return item_ = LogItem::end;
      case RunLogReader::Result::event:
        return item_ = item_of(event().channel);
      case RunLogReader::Result::damage:
        note_damage(reader_.damage().offset, reader_.damage().reason);
    }
  }
}

bool LogStream::read_sample(TickInput& to, SampleNotes& notes) {
  using namespace log_channel;
  const std::string_view channel = event().channel;
  const auto data = event().data;
  if (channel == kCamera) {
    if (!sound(decode_frame(to.frame))) return false;
    ++notes.frames;
    notes.frame_offset = event().offset;
    return true;
  }
  if (channel == kCan) return sound(decode_sample(data, can_message_, to.can));
  if (channel == kLine) return sound(add_sample<raw_line_t>(data, to.edges));
  if (channel == kFix) return sound(add_sample<raw_fix_t>(data, to.fixes));
  if (channel == kCommand) return sound(add_sample<raw_command_t>(data, to.commands));
  if (channel == kReport) return sound(add_sample<raw_report_t>(data, to.reports));
  if (channel == kReflex) {
    if (!sound(set_sample<raw_reflex_t>(data, to.reflex))) return false;
    ++notes.reflexes;
    return true;
  }
  if (!sound(set_sample<raw_timing_t>(data, to.timing))) return false;
  ++notes.timings;
  return true;
}

const char* LogStream::decode_frame(FrameRef& frame) {
  frame = {};
  FrameRef taken = pool_.take();
  if (!taken) throw FatalError(kExitSoftware, "replay: every frame of the pool is in use");
  const char* const reason = decode_sample(event().data, frame_message_, taken.writable());
  if (reason == nullptr) frame = std::move(taken);
  return reason;
}

bool LogStream::read_tick(tick_t& tick) {
  if (!sound(decode_sealed(event().data, tick))) return false;
  const bool possible = tick.index >= 0 && tick.index < kMostTicks && is_stamp(tick.now_ns) && tick.frames <= 1;
  return sound(possible ? nullptr : "a tick holds a value that it cannot have");
}

bool LogStream::read_gap(gap_t& gap) {
  if (!sound(decode_sealed(event().data, gap))) return false;
  const bool possible =
      gap.first_index >= 0 && gap.first_index < kMostTicks && gap.ticks > 0 && gap.ticks < kMostTicks;
  return sound(possible ? nullptr : "a gap holds a value that it cannot have");
}

bool LogStream::read_header(RunHeader& header) {
  run_header_t message{};
  if (!sound(decode_sealed(event().data, message))) return false;
  if (!from_message(message, header)) {
    throw FatalError(kExitBadData,
                     fmt::format("{}: byte {}: a run log of version {}; this program reads version {}",
                                 path(), event().offset, message.format_version, kRunLogVersion));
  }
  header.utime_us = event().time_us;
  return true;
}

bool LogStream::decode_picture(FrameRef& frame, const SampleNotes& notes) {
  if (!frame || decode_(frame.writable())) return true;
  note_damage(notes.frame_offset, "a camera frame cannot be decoded");
  return false;
}

bool LogStream::sound(const char* reason) {
  if (reason != nullptr) note_damage(event().offset, reason);
  return reason == nullptr;
}

void LogStream::refuse(std::uint64_t offset, std::string_view reason) const {
  if (recover_) return;
  throw FatalError(kExitBadData,
                   fmt::format("{}: byte {}: {} (--recover replays what is whole)", path(), offset, reason));
}

void LogStream::note_damage(std::uint64_t offset, std::string_view reason) {
  refuse(offset, reason);
  ++losses_.damaged_places;
  if (losses_.damage.size() < kRememberedDamage) losses_.damage.push_back({offset, std::string(reason)});
}

double LogStream::progress() const {
  return static_cast<double>(reader_.position()) / static_cast<double>(reader_.size());
}

}  // namespace hindsight
