// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
// Samples as the messages of a run log (messages/*.lcm), and back without trusting a byte.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <hindsight/gap_t.hpp>
#include <hindsight/raw_can_t.hpp>
#include <hindsight/raw_command_t.hpp>
#include <hindsight/raw_fix_t.hpp>
#include <hindsight/raw_frame_t.hpp>
#include <hindsight/raw_line_t.hpp>
#include <hindsight/raw_reflex_t.hpp>
#include <hindsight/raw_report_t.hpp>
#include <hindsight/raw_timing_t.hpp>
#include <hindsight/run_header_t.hpp>
#include <hindsight/tick_t.hpp>
#include <span>

#include "drivers/tick_input.h"
#include "sim_replay/big_endian.h"
#include "config/crc32.h"
#include "sim_replay/run_header.h"

namespace hindsight {

constexpr std::int32_t kRunLogVersion = 1;

void to_message(const Frame& frame, raw_frame_t& message);
void to_message(std::span<const CanFrame> frames, raw_can_t& message);
raw_line_t to_message(const LineEdge& edge);
raw_fix_t to_message(const GpsFix& fix);
raw_command_t to_message(const OperatorCommand& command);
raw_report_t to_message(const SourceReport& report);
raw_reflex_t to_message(const ReflexReport& reflex);
raw_timing_t to_message(const LoopTiming& timing);
tick_t to_message(const TickInput& tick);
run_header_t to_message(const RunHeader& header);

/// Within 70 years of the clock's zero, so that no difference of two stamps overflows.
bool is_stamp(std::int64_t ns);

/// False where a value is none that the sample can have. raw_can_t is added to what is there. The frame's
/// `bgr` is left alone, as are all but the first three fields of the tick.
bool from_message(const raw_frame_t& message, Frame& frame);
bool from_message(const raw_can_t& message, std::vector<CanFrame>& frames);
bool from_message(const raw_line_t& message, LineEdge& edge);
bool from_message(const raw_fix_t& message, GpsFix& fix);
bool from_message(const raw_command_t& message, OperatorCommand& command);
bool from_message(const raw_report_t& message, SourceReport& report);
bool from_message(const raw_reflex_t& message, ReflexReport& reflex);
bool from_message(const raw_timing_t& message, LoopTiming& timing);
bool from_message(const tick_t& message, TickInput& tick);
bool from_message(const run_header_t& message, RunHeader& header);

/// Where an encoded message holds the count of one of its arrays, and how long each element is.
struct DeclaredArray {
  std::size_t count_at = 0;
  std::size_t element_bytes = 0;
};
template <class Message>
inline constexpr std::array<DeclaredArray, 0> kDeclaredArrays{};
template <>
inline constexpr std::array<DeclaredArray, 1> kDeclaredArrays<raw_can_t>{{{8, 21}}};
template <>
inline constexpr std::array<DeclaredArray, 1> kDeclaredArrays<raw_frame_t>{{{41, 1}}};
template <>
inline constexpr std::array<DeclaredArray, 5> kDeclaredArrays<run_header_t>{
    {{13, 1}, {17, 1}, {21, 1}, {25, 1}, {29, 1}}};

constexpr std::size_t kCrcBytes = 4;

/// Encodes into `out`, getEncodedSize() bytes, and sets the checksum at its end.
template <class Message>
void encode_sealed(const Message& message, std::span<std::uint8_t> out) {
  message.encode(out.data(), 0, static_cast<int>(out.size()));
  const std::size_t body = out.size() - kCrcBytes;
  write_big_endian(crc32(out.first(body)), out.data() + body);
}

/// Null if the message was decoded, else why not. Generated decoding believes every array's count, so it is
/// called only for bytes of the right type whose counts add up to their size and whose checksum is right.
template <class Message>
const char* decode_sealed(std::span<const std::uint8_t> bytes, Message& message) {
  const auto fixed = static_cast<std::size_t>(Message{}.getEncodedSize());
  if (bytes.size() < fixed) return "a sample is too short";
  if (read_big_endian<std::int64_t>(bytes.data()) != Message::getHash()) return "a sample is of another type";
  std::uint64_t declared = fixed;
  for (const DeclaredArray& array : kDeclaredArrays<Message>) {
    declared +=
        array.element_bytes * std::uint64_t{read_big_endian<std::uint32_t>(bytes.data() + array.count_at)};
  }
  if (declared != bytes.size()) return "a sample's size is not what it declares";
  const std::size_t body = bytes.size() - kCrcBytes;
  if (read_big_endian<std::uint32_t>(bytes.data() + body) != crc32(bytes.first(body)))
    return "a sample's checksum is wrong";
  if (message.decode(bytes.data(), 0, static_cast<int>(bytes.size())) < 0)
    return "a sample cannot be decoded";
  return nullptr;
}

/// decode_sealed and from_message in one.
template <class Message, class Sample>
const char* decode_sample(std::span<const std::uint8_t> bytes, Message& message, Sample& sample) {
  const char* const reason = decode_sealed(bytes, message);
  if (reason != nullptr) return reason;
  return from_message(message, sample) ? nullptr : "a sample holds a value that it cannot have";
}

}  // namespace hindsight
