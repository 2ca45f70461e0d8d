// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/run_log_encoder.h"

#include <algorithm>

#include "sim_replay/log_channels.h"
#include "sim_replay/log_messages.h"

namespace hindsight {
namespace {

template <class Message>
bool append_message(EventSink& log, std::string_view channel, std::int64_t utime_us, const Message& message) {
  const auto out = log.append(channel, utime_us, static_cast<std::size_t>(message.getEncodedSize()));
  if (out.empty()) return false;
  encode_sealed(message, out);
  return true;
}

}  // namespace

struct LogMessages {
  raw_frame_t frame{};
  raw_can_t can{};
};

RunLogEncoder::RunLogEncoder(EventSink& sink) : sink_(sink), messages_(std::make_unique<LogMessages>()) {}

RunLogEncoder::~RunLogEncoder() = default;

bool RunLogEncoder::write_header(const RunHeader& header) {
  return append_message(sink_, log_channel::kHeader, header.utime_us, to_message(header));
}

bool RunLogEncoder::write_tick(const TickInput& tick) {
  write_gap_before(tick);
  if (tick.frame) write_frame(*tick.frame, tick.utime_us);
  if (!tick.can.empty()) write_can(tick.can, tick.utime_us);
  for (const LineEdge& edge : tick.edges) write_edge(edge, tick.utime_us);
  for (const GpsFix& fix : tick.fixes) write_fix(fix, tick.utime_us);
  for (const OperatorCommand& command : tick.commands) write_command(command, tick.utime_us);
  for (const SourceReport& report : tick.reports) {
    append_message(sink_, log_channel::kReport, tick.utime_us, to_message(report));
  }
  append_message(sink_, log_channel::kReflex, tick.utime_us, to_message(tick.reflex));
  append_message(sink_, log_channel::kTiming, tick.utime_us, to_message(tick.timing));
  return append_message(sink_, log_channel::kTick, tick.utime_us, to_message(tick));
}

bool RunLogEncoder::write_published(std::string_view channel, std::int64_t utime_us,
                                    std::span<const std::uint8_t> bytes) {
  const auto out = sink_.append(channel, utime_us, bytes.size());
  std::copy_n(bytes.begin(), out.size(), out.begin());
  return out.data() != nullptr;  // also where there are no bytes
}

bool RunLogEncoder::write_frame(const Frame& frame, std::int64_t utime_us) {
  to_message(frame, messages_->frame);
  return append_message(sink_, log_channel::kCamera, utime_us, messages_->frame);
}

bool RunLogEncoder::write_can(std::span<const CanFrame> frames, std::int64_t utime_us) {
  to_message(frames, messages_->can);
  return append_message(sink_, log_channel::kCan, utime_us, messages_->can);
}

bool RunLogEncoder::write_edge(const LineEdge& edge, std::int64_t utime_us) {
  return append_message(sink_, log_channel::kLine, utime_us, to_message(edge));
}

bool RunLogEncoder::write_fix(const GpsFix& fix, std::int64_t utime_us) {
  return append_message(sink_, log_channel::kFix, utime_us, to_message(fix));
}

bool RunLogEncoder::write_command(const OperatorCommand& command, std::int64_t utime_us) {
  return append_message(sink_, log_channel::kCommand, utime_us, to_message(command));
}

void RunLogEncoder::write_gap_before(const TickInput& tick) {
  if (tick.index > next_index_) write_gap(next_index_, tick.index, tick.utime_us);
  next_index_ = tick.index + 1;
}

bool RunLogEncoder::write_gap(std::uint64_t from, std::uint64_t to, std::int64_t utime_us) {
  const gap_t gap{static_cast<std::int64_t>(from), static_cast<std::int64_t>(to - from), 0};
  return append_message(sink_, log_channel::kGap, utime_us, gap);
}

}  // namespace hindsight
