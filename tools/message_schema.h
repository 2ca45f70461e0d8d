// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What the bytes of an LCM message mean, read from the .lcm definitions themselves: so that a tool can name the field
// in which two messages differ, for any type, without a line of code for each.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hindsight::tools {

/// One member of an LCM struct.
struct MessageMember {
  std::string name;
  std::string type;                     ///< primitive, or PACKAGE.TYPE
  std::vector<std::string> dimensions;  ///< numbers, or names of earlier members
};

class MessageSchema {
 public:
  /// Adds the struct of one .lcm file. FatalError(kExitSoftware) if it is not understood: the files are our own.
  void add(std::string_view lcm_text);

  /// A field with its place and value, as text.
  struct Field {
    std::string path;  ///< such as components[3].mean[1]
    std::size_t offset = 0;
    std::size_t size = 0;
    std::string value;
  };
  /// All fields of an encoded message (its 8-byte fingerprint first) of a type such as hindsight.state_t, as far as
  /// the bytes go.
  std::vector<Field> fields(const std::string& type, std::span<const std::uint8_t> bytes) const;

 private:
  struct Cursor;
  void walk(const std::string& type, const std::string& path, Cursor& cursor) const;
  void walk_array(const MessageMember& member, const std::vector<std::int64_t>& sizes, std::size_t dimension,
                  const std::string& path, Cursor& cursor) const;
  void walk_value(const std::string& type, const std::string& path, Cursor& cursor) const;

  std::map<std::string, std::vector<MessageMember>> structs_;
};

/// All definitions of the telemetry messages, as built into the program.
const MessageSchema& telemetry_schema();

/// The type that is published on a channel of ours; empty if the channel is not ours.
std::string type_of_channel(std::string_view channel);

}  // namespace hindsight::tools
