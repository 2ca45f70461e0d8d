// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/can_codec.h"

#include <fmt/format.h>
#include <linux/can.h>

#include <algorithm>
#include <cmath>

#include "config/exit_code.h"

namespace hindsight {
namespace {

std::uint64_t mask_of(int bits) { return bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1; }

// The payload as one number: byte 0 is the least (little endian) or the most significant.
std::uint64_t load(const CanPayload& data, bool little_endian) {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < data.size(); ++i) {
    word |= std::uint64_t{data[i]} << (8 * (little_endian ? i : data.size() - 1 - i));
  }
  return word;
}

void store(CanPayload& data, bool little_endian, std::uint64_t word) {
  for (std::size_t i = 0; i < data.size(); ++i) {
    data[i] = static_cast<std::uint8_t>(word >> (8 * (little_endian ? i : data.size() - 1 - i)));
  }
}

// How far the signal's least significant bit is from that number's.
int shift_of(const DbcSignal& signal) {
  if (signal.little_endian) return signal.start_bit;
  const int bits_before = signal.start_bit / 8 * 8 + 7 - signal.start_bit % 8;
  return 64 - bits_before - signal.length_bits;
}

constexpr std::array<std::uint8_t, 256> make_crc_table() {
  std::array<std::uint8_t, 256> table{};
  for (unsigned i = 0; i < 256; ++i) {
    unsigned crc = i;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 0x80U) != 0 ? (crc << 1U) ^ 0x1DU : crc << 1U;
    table[i] = static_cast<std::uint8_t>(crc);
  }
  return table;
}
constexpr auto kCrcTable = make_crc_table();

const DbcSignal& protection_signal(const Dbc& dbc, const DbcMessage& message, const std::string& name,
                                   const char* what, int least_bits, int most_bits) {
  const DbcSignal* signal = message.find(name);
  if (signal == nullptr || !signal->unsupported.empty() || signal->is_signed ||
      signal->length_bits < least_bits || signal->length_bits > most_bits) {
    throw FatalError(kExitConfiguration,
                     fmt::format("{}:{}: message {} needs an unsigned {} signal {} of {} to {} bits",
                                 dbc.path, message.line, message.name, what, name, least_bits, most_bits));
  }
  return *signal;
}

}  // namespace

std::uint64_t extract_bits(const CanPayload& data, const DbcSignal& signal) {
  return (load(data, signal.little_endian) >> shift_of(signal)) & mask_of(signal.length_bits);
}

void insert_bits(CanPayload& data, const DbcSignal& signal, std::uint64_t bits) {
  const std::uint64_t mask = mask_of(signal.length_bits);
  const int shift = shift_of(signal);
  const std::uint64_t rest = load(data, signal.little_endian) & ~(mask << shift);
  store(data, signal.little_endian, rest | (bits & mask) << shift);
}

double decode_signal(const CanPayload& data, const DbcSignal& signal) {
  const std::uint64_t bits = extract_bits(data, signal);
  if (!signal.is_signed) return static_cast<double>(bits) * signal.factor + signal.offset;
  const int unused = 64 - signal.length_bits;
  const std::int64_t raw = static_cast<std::int64_t>(bits << unused) >> unused;
  return static_cast<double>(raw) * signal.factor + signal.offset;
}

void encode_signal(CanPayload& data, const DbcSignal& signal, double value) {
  if (signal.min < signal.max) value = std::clamp(value, signal.min, signal.max);
  const int value_bits = signal.is_signed ? signal.length_bits - 1 : signal.length_bits;
  const double highest = std::ldexp(1.0, value_bits) - 1.0;
  const double lowest = signal.is_signed ? -std::ldexp(1.0, value_bits) : 0.0;
  const double raw = std::clamp(std::round((value - signal.offset) / signal.factor), lowest, highest);
  insert_bits(data, signal, static_cast<std::uint64_t>(static_cast<std::int64_t>(raw)));
}

bool within_limits(const DbcSignal& signal, double value) {
  if (signal.min == 0.0 && signal.max == 0.0) return true;
  const double half_step = 0.5 * std::abs(signal.factor);
  return value >= signal.min - half_step && value <= signal.max + half_step;
}

std::uint8_t crc8_j1850(std::uint32_t id, const CanPayload& data, int length) {
  std::uint8_t crc = 0xFF;
  for (unsigned shift = 0; shift < 32; shift += 8) crc = kCrcTable[crc ^ ((id >> shift) & 0xFFU)];
  for (std::size_t i = 0; i < static_cast<std::size_t>(length); ++i) {
    crc = kCrcTable[static_cast<std::size_t>(crc ^ data[i])];
  }
  return crc ^ 0xFFU;
}

ProtectedMessage::ProtectedMessage(const Dbc& dbc, const DbcMessage& message, const std::string& counter,
                                   const std::string& checksum)
    : name_(message.name),
      id_(message.extended ? message.id | CAN_EFF_FLAG : message.id),
      length_bytes_(message.length_bytes),
      counter_(protection_signal(dbc, message, counter, "counter", 2, 16)),
      checksum_(protection_signal(dbc, message, checksum, "checksum", 8, 8)) {
  if (length_bytes_ > CAN_MAX_DLEN) {
    throw FatalError(kExitConfiguration,
                     fmt::format("{}:{}: message {} has {} bytes, more than the {} of a CAN frame", dbc.path,
                                 message.line, name_, length_bytes_, CAN_MAX_DLEN));
  }
}

std::uint8_t ProtectedMessage::checksum_of(CanPayload data) const {
  insert_bits(data, checksum_, 0);
  return crc8_j1850(id_ & CAN_EFF_MASK, data, length_bytes_);
}

FrameFault ProtectedMessage::check(const CanFrame& frame) const {
  if (frame.length != length_bytes_) return FrameFault::wrong_length;
  const bool right = extract_bits(frame.data, checksum_) == checksum_of(frame.data);
  return right ? FrameFault::none : FrameFault::wrong_checksum;
}

std::uint32_t ProtectedMessage::counter(const CanFrame& frame) const {
  return static_cast<std::uint32_t>(extract_bits(frame.data, counter_));
}

std::uint32_t ProtectedMessage::next_counter(std::uint32_t counter) const {
  return static_cast<std::uint32_t>((counter + 1) & mask_of(counter_.length_bits));
}

void ProtectedMessage::seal(CanFrame& frame, std::uint32_t counter) const {
  frame.id = id_;
  frame.length = static_cast<std::uint8_t>(length_bytes_);
  insert_bits(frame.data, counter_, counter);
  insert_bits(frame.data, checksum_, checksum_of(frame.data));
}

}  // namespace hindsight
