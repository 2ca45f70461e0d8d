// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The only file that includes toml++: it is slow to compile.
#include "config/config_document.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <fstream>
#include <sstream>
#include <utility>

#include "config/exit_code.h"

namespace hindsight {
namespace {

constexpr std::size_t kLongestValueText = 60;

ConfigPlace place_of(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

ConfigScalar scalar_of(const toml::node& node) {
  if (const auto* v = node.as_boolean()) return v->get();
  if (const auto* v = node.as_integer()) return v->get();
  if (const auto* v = node.as_floating_point()) return v->get();
  if (const auto* v = node.as_string()) return v->get();
  return std::monostate{};
}

ConfigValue value_of(const toml::node& node) {
  const toml::array* array = node.as_array();
  if (array == nullptr) return scalar_of(node);
  std::vector<ConfigScalar> elements;
  for (const toml::node& element : *array) elements.push_back(scalar_of(element));
  return elements;
}

std::string text_of(const toml::node& node) {
  std::ostringstream out;
  node.visit([&out](const auto& value) { out << value; });
  std::string text = out.str();
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  if (text.size() <= kLongestValueText) return text;
  std::size_t end = kLongestValueText;
  while ((static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // not inside a UTF-8 sequence
  return text.substr(0, end) + "...";
}

/// A dot inside a quoted key must not pass for one between tables.
std::string joined(const std::string& section, std::string_view name) {
  const bool quoted = name.find('.') != std::string_view::npos;
  const std::string last = quoted ? fmt::format("\"{}\"", name) : std::string(name);
  return section.empty() ? last : section + "." + last;
}

void flatten(const toml::table& table, const std::string& section, ConfigDocument& into) {
  for (const auto& [key, node] : table) {
    if (const toml::table* child = node.as_table()) {
      const std::string name = joined(section, key.str());
      into.sections.push_back({name, place_of(key.source())});
      flatten(*child, name, into);
    } else {
      into.entries.push_back({section, std::string(key.str()), value_of(node), text_of(node),
                              place_of(key.source()), place_of(node.source())});
    }
  }
}

}  // namespace

ConfigDocument ConfigDocument::parse(std::string_view toml_text, std::string file_name) {
  ConfigDocument document{.file_name = std::move(file_name), .sections = {}, .entries = {}};
  try {
    flatten(toml::parse(toml_text), "", document);
  } catch (const toml::parse_error& error) {
    const ConfigPlace place = place_of(error.source());
    throw FatalError(kExitConfiguration, fmt::format("{}:{}:{}: not TOML: {}", document.file_name, place.line,
                                                     place.column, error.description()));
  }
  return document;
}

ConfigDocument ConfigDocument::load(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  file.peek();  // opening a folder succeeds, reading it does not
  if (!file.is_open() || file.bad()) {
    throw FatalError(kExitNoInput, fmt::format("{}: cannot be read; expected a configuration file", path));
  }
  std::ostringstream text;
  text << file.rdbuf();
  return parse(text.view(), path);
}

}  // namespace hindsight
