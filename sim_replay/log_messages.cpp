// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/log_messages.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace hindsight {
namespace {

constexpr std::int32_t kMaxPictureSide_px = 16384;

template <class Enum>
bool known(std::uint8_t value, Enum last) {
  return value <= static_cast<std::uint8_t>(last);
}

std::uint32_t low_word(std::int64_t value) { return static_cast<std::uint32_t>(value); }

can_frame_t to_element(const CanFrame& frame) {
  can_frame_t element{};
  element.stamp_ns = frame.stamp.count();
  element.id = static_cast<std::int32_t>(frame.id);
  element.length = frame.length;
  std::copy(frame.data.begin(), frame.data.end(), element.data);
  return element;
}

CanFrame from_element(const can_frame_t& element) {
  CanFrame frame{Time{element.stamp_ns}, static_cast<std::uint32_t>(element.id), element.length, {}};
  std::copy(std::begin(element.data), std::end(element.data), frame.data.begin());
  return frame;
}

template <class Bytes>
void put(const Bytes& from, std::int32_t& size, std::vector<std::uint8_t>& to) {
  size = static_cast<std::int32_t>(from.size());
  to.assign(from.begin(), from.end());
}

std::string text(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

}  // namespace

bool is_stamp(std::int64_t ns) { return std::abs(ns / 2) <= std::int64_t{1} << 60; }

void to_message(const Frame& frame, raw_frame_t& message) {
  message.stamp_ns = frame.stamp.count();
  message.sequence = frame.sequence;
  message.format = static_cast<std::uint8_t>(frame.format);
  message.width_px = frame.width_px;
  message.height_px = frame.height_px;
  message.exposure_s = frame.exposure_s;
  message.gain = frame.gain;
  put(frame.bytes, message.size, message.data);
}

bool from_message(const raw_frame_t& message, Frame& frame) {
  const auto side_ok = [](std::int32_t side_px) { return side_px > 0 && side_px <= kMaxPictureSide_px; };
  if (!known(message.format, PixelFormat::bgr24) || !side_ok(message.width_px) || !side_ok(message.height_px) ||
      !is_stamp(message.stamp_ns))
    return false;
  frame.stamp = Time{message.stamp_ns};
  frame.sequence = low_word(message.sequence);
  frame.format = static_cast<PixelFormat>(message.format);
  frame.width_px = message.width_px;
  frame.height_px = message.height_px;
  frame.exposure_s = message.exposure_s;
  frame.gain = message.gain;
  // Generated decoding leaves the last message's data where there is none.
  frame.bytes.assign(message.data.begin(), message.data.begin() + message.size);
  return true;
}

void to_message(std::span<const CanFrame> frames, raw_can_t& message) {
  message.n = static_cast<std::int32_t>(frames.size());
  message.frames.resize(frames.size());
  std::transform(frames.begin(), frames.end(), message.frames.begin(), to_element);
}

bool from_message(const raw_can_t& message, std::vector<CanFrame>& frames) {
  const auto possible = [](const can_frame_t& element) { return element.length <= 8 && is_stamp(element.stamp_ns); };
  if (!std::all_of(message.frames.begin(), message.frames.end(), possible)) return false;
  std::transform(message.frames.begin(), message.frames.end(), std::back_inserter(frames), from_element);
  return true;
}

raw_line_t to_message(const LineEdge& edge) {
  return {edge.stamp.count(), static_cast<std::uint8_t>(edge.line), edge.active, 0};
}

bool from_message(const raw_line_t& message, LineEdge& edge) {
  edge = {Time{message.stamp_ns}, static_cast<Line>(message.line), message.active != 0};
  return known(message.line, Line::estop) && is_stamp(message.stamp_ns);
}

raw_fix_t to_message(const GpsFix& fix) {
  return {fix.stamp.count(), fix.latitude_deg, fix.longitude_deg, fix.altitude_m, fix.horizontal_sigma_m, 0};
}

bool from_message(const raw_fix_t& message, GpsFix& fix) {
  fix = {Time{message.stamp_ns}, message.latitude_deg, message.longitude_deg, message.altitude_m,
         message.horizontal_sigma_m};
  return is_stamp(message.stamp_ns);
}

raw_command_t to_message(const OperatorCommand& command) {
  return {command.stamp.count(),
          static_cast<std::uint8_t>(command.kind),
          command.a,
          command.b,
          command.sequence,
          0};
}

bool from_message(const raw_command_t& message, OperatorCommand& command) {
  command = {Time{message.stamp_ns}, static_cast<CommandKind>(message.kind), message.a, message.b,
             message.sequence};
  return known(message.kind, CommandKind::save_model) && is_stamp(message.stamp_ns);
}

raw_report_t to_message(const SourceReport& report) {
  return {report.stamp.count(),
          static_cast<std::uint8_t>(report.source),
          static_cast<std::uint8_t>(report.state),
          report.dropped,
          report.error_code,
          0};
}

bool from_message(const raw_report_t& message, SourceReport& report) {
  report = {Time{message.stamp_ns}, static_cast<Source>(message.source),
            static_cast<SourceState>(message.state), low_word(message.dropped), message.error_code};
  return known(message.source, Source::operator_link) && known(message.state, SourceState::absent) &&
         is_stamp(message.stamp_ns);
}

raw_reflex_t to_message(const ReflexReport& reflex) {
  return {reflex.stamp.count(),
          reflex.left_mps,
          reflex.right_mps,
          reflex.stop_reason,
          reflex.frames_sent,
          reflex.send_errors,
          0};
}

bool from_message(const raw_reflex_t& message, ReflexReport& reflex) {
  reflex = {Time{message.stamp_ns},
            message.left_mps,
            message.right_mps,
            message.stop_reason,
            low_word(message.frames_sent),
            low_word(message.send_errors)};
  return is_stamp(message.stamp_ns);
}

raw_timing_t to_message(const LoopTiming& timing) {
  return {timing.wake_latency.count(), timing.step_duration.count(), timing.overruns, timing.recorder_dropped,
          0};
}

bool from_message(const raw_timing_t& message, LoopTiming& timing) {
  timing = {Time{message.wake_latency_ns}, Time{message.step_duration_ns}, low_word(message.overruns),
            low_word(message.recorder_dropped)};
  return true;
}

tick_t to_message(const TickInput& tick) {
  const auto count = [](const auto& samples) { return static_cast<std::int32_t>(samples.size()); };
  return {static_cast<std::int64_t>(tick.index),
          tick.now.count(),
          tick.utime_us,
          tick.frame ? 1 : 0,
          count(tick.can),
          count(tick.edges),
          count(tick.fixes),
          count(tick.commands),
          count(tick.reports),
          0};
}

bool from_message(const tick_t& message, TickInput& tick) {
  tick.index = static_cast<std::uint64_t>(message.index);
  tick.now = Time{message.now_ns};
  tick.utime_us = message.utime_us;
  return message.index >= 0;
}

run_header_t to_message(const RunHeader& header) {
  run_header_t message{};
  message.format_version = kRunLogVersion;
  message.ticks_recorded = header.ticks_recorded;
  put(header.build_id, message.build_id_size, message.build_id);
  put(header.configuration, message.configuration_size, message.configuration);
  put(header.dbc, message.dbc_size, message.dbc);
  put(header.calibration, message.calibration_size, message.calibration);
  put(header.mixture, message.mixture_size, message.mixture);
  return message;
}

bool from_message(const run_header_t& message, RunHeader& header) {
  header.ticks_recorded = message.ticks_recorded != 0;
  header.build_id = text(message.build_id);
  header.configuration = text(message.configuration);
  header.dbc = text(message.dbc);
  header.calibration = text(message.calibration);
  header.mixture = message.mixture;
  return message.format_version == kRunLogVersion;
}

}  // namespace hindsight
