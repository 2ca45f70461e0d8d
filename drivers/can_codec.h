// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "drivers/dbc.h"
#include "drivers/samples.h"

namespace hindsight {

using CanPayload = std::array<std::uint8_t, 8>;

/// The signal's raw bits, right-aligned, and the reverse, which leaves all other bits alone.
std::uint64_t extract_bits(const CanPayload& data, const DbcSignal& signal);
void insert_bits(CanPayload& data, const DbcSignal& signal, std::uint64_t bits);

/// The signal's value in its unit.
double decode_signal(const CanPayload& data, const DbcSignal& signal);
/// Writes the nearest value that the signal's bits and limits allow. `value` must not be NaN.
void encode_signal(CanPayload& data, const DbcSignal& signal, double value);
/// Whether a value lies within the limits that the file declares (up to half a step).
bool within_limits(const DbcSignal& signal, double value);

/// CRC-8 SAE J1850: polynomial 0x1D, start 0xFF, final XOR 0xFF, not reflected; over the identifier as 32
/// bits, least significant byte first (without flags), and then the first `length` bytes.
std::uint8_t crc8_j1850(std::uint32_t id, const CanPayload& data, int length);

enum class FrameFault : std::uint8_t { none, wrong_length, wrong_checksum };

/// A message whose frames carry a counter and a checksum. The checksum is crc8_j1850 over the message with
/// the checksum's own bits zero; the counter goes up by one from frame to frame and wraps at the width of its
/// signal.
class ProtectedMessage {
 public:
  /// Throws FatalError(kExitConfiguration), naming file, message and signal, where the message has no counter
  /// of 2 bits or more or no checksum of 8 bits of these names.
  ProtectedMessage(const Dbc& dbc, const DbcMessage& message, const std::string& counter,
                   const std::string& checksum);

  const std::string& name() const { return name_; }
  /// As in CanFrame::id: CAN_EFF_FLAG set where it is extended.
  std::uint32_t id() const { return id_; }
  int length_bytes() const { return length_bytes_; }

  /// Length and checksum; the frame must be of this id.
  FrameFault check(const CanFrame& frame) const;
  std::uint32_t counter(const CanFrame& frame) const;
  std::uint32_t next_counter(std::uint32_t counter) const;
  /// Sets id, length, counter (wrapped to its width) and checksum of a frame whose signals are in place.
  void seal(CanFrame& frame, std::uint32_t counter) const;

 private:
  std::uint8_t checksum_of(CanPayload data) const;

  std::string name_;
  std::uint32_t id_ = 0;
  int length_bytes_ = 0;
  DbcSignal counter_;
  DbcSignal checksum_;
};

}  // namespace hindsight
