// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hindsight {

/// A signal of a DBC file: where it lies in its message, and value = raw * factor + offset.
struct DbcSignal {
  std::string name;
  int start_bit =
      0;  ///< as in the file: little endian the least significant bit, big endian the most significant one
  int length_bits = 0;
  bool little_endian = true;
  bool is_signed = false;
  double factor = 1.0;
  double offset = 0.0;
  double min = 0.0;  ///< min == max == 0: not limited
  double max = 0.0;
  std::string unit;
  std::string unsupported;  ///< why its value cannot be had ("multiplexed", "floating point"), or empty
};

struct DbcMessage {
  std::string name;
  std::uint32_t id = 0;  ///< without flags
  bool extended = false;
  int length_bytes = 0;
  std::string sender;
  std::vector<DbcSignal> signals;
  int line = 0;  ///< of its BO_

  const DbcSignal* find(std::string_view signal) const;
};

/// A DBC file's messages. `path` is kept for messages to the user.
struct Dbc {
  std::string path;
  std::vector<DbcMessage> messages;

  const DbcMessage* find(std::string_view message) const;
};

/// Reads a DBC file: BO_ and SG_ in full; the other sections (VERSION, NS_, BS_, BU_, CM_, BA_..., VAL_...)
/// are stepped over. Throws FatalError: kExitNoInput where it cannot be read, kExitConfiguration, with
/// file:line, where it is wrong: malformed lines, names twice, signals that overlap or leave their message.
Dbc read_dbc(const std::string& path);

/// The same from text; `path` is for messages only.
Dbc parse_dbc(std::string_view text, const std::string& path);

}  // namespace hindsight
