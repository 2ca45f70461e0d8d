// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Operator commands as packets: LCM's short-message wire format ("LC02", sequence number, channel, payload) around a
// fixed-size hindsight.command_t, so that generated encoders and LCM's own tools can send it. The daemon never
// subscribes with liblcm, which one malformed packet can crash: everything here is bounds-checked and fuzzable.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/samples.h"

namespace hindsight {

constexpr std::size_t kCommandKeyBytes = 32;
using CommandKey = std::array<std::uint8_t, kCommandKeyBytes>;

enum class CommandVerdict : std::uint8_t {
  accepted = 0,
  malformed,      ///< not a short LCM message, or of another size
  wrong_channel,  ///< not on the allow-list
  wrong_mac,      ///< forged, or made with another key
  replayed,       ///< a sequence number not above the last accepted one
  untimely,       ///< its time is too far from ours
  bad_value       ///< unknown kind, or a number that is not finite
};
constexpr int kCommandVerdictCount = 7;

/// Decides on packets. Keeps the highest sequence number accepted, nothing else. A stop is obeyed whatever its time and
/// number: the operator's clock may differ or be set, and a stop sent again does no harm. Where this machine's clock is
/// set back, the numbers begin anew.
class CommandDecoder {
 public:
  /// `window_us`: how far a command's time may be from `utime_us` of decode(); without a key no MAC is asked for.
  CommandDecoder(std::optional<CommandKey> key, std::int64_t window_us);

  /// On `accepted`, `command` holds the command, stamped with `stamp`. Never throws, never allocates.
  CommandVerdict decode(std::span<const std::uint8_t> packet, Time stamp, std::int64_t utime_us,
                        OperatorCommand& command);

 private:
  /// A sequence number is the sender's time in microseconds.
  CommandVerdict judge_age(std::int64_t sent_us, std::int64_t sequence, std::int64_t now_us);

  std::optional<CommandKey> key_;
  std::int64_t window_us_;
  std::int64_t last_sequence_ = 0;
};

/// The packet for a command; utime and sequence are both `utime_us`.
std::vector<std::uint8_t> encode_command(const OperatorCommand& command, std::int64_t utime_us,
                                         const std::optional<CommandKey>& key);

/// Reads a key: 64 hexadecimal digits. FatalError(kExitConfiguration) if the file is absent, of another form, or
/// readable by others than its owner.
CommandKey read_command_key(const std::string& file);

}  // namespace hindsight
