// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/replay_source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "config/exit_code.h"
#include "sim_replay/log_channels.h"
#include "sim_replay/run_log_reader.h"

namespace hindsight {
namespace {

/// For a log whose header is missing.
bool holds_a_tick(const std::filesystem::path& path) {
  RunLogReader reader(path, true);
  for (auto result = reader.next(); result != RunLogReader::Result::end; result = reader.next()) {
    if (result == RunLogReader::Result::event && reader.event().channel == log_channel::kTick) return true;
  }
  return false;
}

std::string why_no_samples(const std::string& path, const std::set<std::string>& channels, bool has_header) {
  if (has_header) return fmt::format("{}: a run log without samples", path);
  return fmt::format(
      "{}: an LCM event log, but not of a Hindsight run: it has no samples of ours, only channels {}", path,
      fmt::join(channels, ", "));
}

}  // namespace

ReplaySource::ReplaySource(const std::filesystem::path& path, FramePool& pool, DecodeFrame decode,
                           ReplayOptions options)
    : stream_(path, pool, std::move(decode), options.recover) {
  read_up_to_first_sample();
  recorded_ = header_ ? header_->ticks_recorded : holds_a_tick(path);
  if (recorded_) {
    ticks_ = std::make_unique<RecordedTicks>(stream_);
  } else {
    ticks_ = std::make_unique<SynthesisedTicks>(stream_, options.tick_period);
  }
}

void ReplaySource::read_up_to_first_sample() {
  constexpr std::size_t kNamed = 5;
  std::set<std::string> channels;
  for (;;) {
    switch (stream_.next()) {
      case LogItem::header:
        header_.emplace();
        if (!stream_.read_header(*header_)) header_.reset();
        break;
      case LogItem::published:
        if (channels.size() < kNamed) channels.emplace(stream_.event().channel);
        break;
      case LogItem::end:
        throw FatalError(kExitBadData, why_no_samples(stream_.path(), channels, header_.has_value()));
      case LogItem::sample:
      case LogItem::tick:
      case LogItem::gap:
        return stream_.hold();
    }
  }
}

}  // namespace hindsight
