// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/message_schema.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdlib>
#include <regex>
#include <sstream>

#include "config/exit_code.h"
#include "tools/embedded_messages.h"

namespace hindsight::tools {
namespace {

std::size_t primitive_size(const std::string& type) {
  static const std::map<std::string, std::size_t> sizes = {{"int8_t", 1},  {"byte", 1},    {"boolean", 1},
                                                           {"int16_t", 2}, {"int32_t", 4}, {"float", 4},
                                                           {"int64_t", 8}, {"double", 8}};
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

std::string without_comments(std::string_view text) {
  return std::regex_replace(std::string(text), std::regex("//[^\n]*"), "");
}

}  // namespace

void MessageSchema::add(std::string_view lcm_text) {
  const std::string text = without_comments(lcm_text);
  std::smatch head;
  static const std::regex declaration(R"(package\s+(\w+)\s*;\s*struct\s+(\w+)\s*\{([^}]*)\})");
  if (!std::regex_search(text, head, declaration)) throw FatalError(kExitSoftware, "message definition not understood");
  const std::string package = head[1];
  const std::string body = head[3];
  std::vector<MessageMember> members;
  static const std::regex member(R"((\w+(?:\.\w+)?)\s+(\w+)\s*((?:\[\s*\w+\s*\])*)\s*;)");
  static const std::regex dimension(R"(\[\s*(\w+)\s*\])");
  for (std::sregex_iterator it(body.begin(), body.end(), member), end; it != end; ++it) {
    MessageMember m{(*it)[2], (*it)[1], {}};
    if (primitive_size(m.type) == 0 && m.type != "string" && m.type.find('.') == std::string::npos) {
      m.type = package + "." + m.type;
    }
    const std::string dimensions = (*it)[3];
    for (std::sregex_iterator d(dimensions.begin(), dimensions.end(), dimension); d != end; ++d) {
      m.dimensions.push_back((*d)[1]);
    }
    members.push_back(m);
  }
  structs_[package + "." + head[2].str()] = members;
}

struct MessageSchema::Cursor {
  std::span<const std::uint8_t> bytes;
  std::size_t offset = 0;
  std::vector<Field> fields;
  std::map<std::string, std::int64_t> integers;  ///< by full path, for the dimensions of later arrays

  bool ended() const { return offset >= bytes.size(); }
  std::uint64_t take(std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size && offset < bytes.size(); ++i) value = value << 8U | bytes[offset++];
    return value;
  }
};

void MessageSchema::walk_value(const std::string& type, const std::string& path, Cursor& cursor) const {
  if (cursor.ended()) return;
  if (structs_.contains(type)) return walk(type, path, cursor);
  Field field{path, cursor.offset, primitive_size(type), ""};
  if (type == "string") {
    const std::size_t length = cursor.take(4);
    const std::size_t end = std::min(cursor.bytes.size(), cursor.offset + length);
    for (; cursor.offset < end; ++cursor.offset) {
      if (cursor.bytes[cursor.offset] != 0) field.value += static_cast<char>(cursor.bytes[cursor.offset]);
    }
    field.size = cursor.offset - field.offset;
  } else {
    const std::uint64_t raw = cursor.take(field.size);
    if (type == "float") {
      field.value = fmt::format("{}", std::bit_cast<float>(static_cast<std::uint32_t>(raw)));
    } else if (type == "double") {
      field.value = fmt::format("{}", std::bit_cast<double>(raw));
    } else {
      const unsigned shift = 64U - 8U * static_cast<unsigned>(field.size);
      const std::int64_t value = static_cast<std::int64_t>(raw << shift) >> shift;
      field.value = fmt::format("{}", value);
      cursor.integers[path] = value;
    }
  }
  cursor.fields.push_back(std::move(field));
}

void MessageSchema::walk_array(const MessageMember& member, const std::vector<std::int64_t>& sizes,
                               std::size_t dimension, const std::string& path, Cursor& cursor) const {
  if (dimension == sizes.size()) return walk_value(member.type, path, cursor);
  for (std::int64_t i = 0; i < sizes[dimension] && !cursor.ended(); ++i) {
    walk_array(member, sizes, dimension + 1, fmt::format("{}[{}]", path, i), cursor);
  }
}

void MessageSchema::walk(const std::string& type, const std::string& path, Cursor& cursor) const {
  const std::string prefix = path.empty() ? "" : path + ".";
  for (const MessageMember& member : structs_.at(type)) {
    std::vector<std::int64_t> sizes;
    for (const std::string& dimension : member.dimensions) {
      const bool is_number = dimension.find_first_not_of("0123456789") == std::string::npos;
      sizes.push_back(is_number ? std::strtoll(dimension.c_str(), nullptr, 10) : cursor.integers[prefix + dimension]);
    }
    walk_array(member, sizes, 0, prefix + member.name, cursor);
  }
}

std::vector<MessageSchema::Field> MessageSchema::fields(const std::string& type,
                                                        std::span<const std::uint8_t> bytes) const {
  if (!structs_.contains(type)) return {};
  Cursor cursor{bytes, 8, {}, {}};
  walk(type, "", cursor);
  return std::move(cursor.fields);
}

const MessageSchema& telemetry_schema() {
  static const MessageSchema schema = [] {
    MessageSchema made;
    for (const char* text : kTelemetryMessages) made.add(text);
    return made;
  }();
  return schema;
}

std::string type_of_channel(std::string_view channel) {
  if (channel == "POSE") return "bot_core.pose_t";
  constexpr std::string_view prefix = "HINDSIGHT_";
  if (!channel.starts_with(prefix)) return "";
  std::string name(channel.substr(prefix.size()));
  for (char& c : name) c = static_cast<char>(std::tolower(c));
  return "hindsight." + name + "_t";
}

}  // namespace hindsight::tools
