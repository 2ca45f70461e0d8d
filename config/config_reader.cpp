// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "config/config_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "config/config_printer.h"
#include "config/exit_code.h"
#include "config/nearest_name.h"

namespace hindsight {
namespace {

bool is_allowed(double value, const Range& allowed) { return value >= allowed.min && value <= allowed.max; }
bool is_allowed(const std::string& value, const Choices& allowed) {
  return std::find(allowed.values.begin(), allowed.values.end(), value) != allowed.values.end();
}
bool is_allowed(const std::string&, AnyText) { return true; }
bool is_allowed(bool, YesNo) { return true; }
template <class T, class Allowed>
bool is_allowed(const std::vector<T>& values, const Allowed& allowed) {
  return std::all_of(values.begin(), values.end(), [&](const T& v) { return is_allowed(v, allowed); });
}

// convert(): the value as the parameter's type, or false where it has another.

template <class T>
bool convert(const ConfigScalar& from, T& to) {
  const T* value = std::get_if<T>(&from);
  if (value != nullptr) to = *value;
  return value != nullptr;
}

bool convert(const ConfigScalar& from, int& to) {
  const auto* value = std::get_if<std::int64_t>(&from);
  if (value == nullptr || *value < std::numeric_limits<int>::min() ||
      *value > std::numeric_limits<int>::max()) {
    return false;
  }
  to = static_cast<int>(*value);
  return true;
}

bool convert(const ConfigScalar& from, double& to) {
  if (const auto* integer = std::get_if<std::int64_t>(&from)) {
    to = static_cast<double>(*integer);
    return true;
  }
  const double* value = std::get_if<double>(&from);
  if (value != nullptr) to = *value;
  return value != nullptr;
}

template <class T>
bool convert(const ConfigValue& from, T& to) {
  const auto* scalar = std::get_if<ConfigScalar>(&from);
  return scalar != nullptr && convert(*scalar, to);
}

template <class T>
bool convert(const ConfigValue& from, std::vector<T>& to) {
  const auto* elements = std::get_if<std::vector<ConfigScalar>>(&from);
  if (elements == nullptr) return false;
  for (const ConfigScalar& element : *elements) {
    T converted{};
    if (!convert(element, converted)) return false;
    to.push_back(std::move(converted));
  }
  return true;
}

std::string type_text(bool) { return "true or false"; }
std::string type_text(int) { return "an integer"; }
std::string type_text(double) { return "a number"; }
std::string type_text(const std::string&) { return "a string"; }
std::string type_text(const std::vector<double>&) { return "a list of numbers"; }
std::string type_text(const std::vector<std::string>&) { return "a list of strings"; }

template <class T, class Allowed>
std::string expected_text(const T& value, const Allowed& allowed) {
  const std::string limits = allowed_text(allowed);
  return limits.empty() ? type_text(value) : type_text(value) + ", " + limits;
}
template <class T, class Allowed>
std::string expected_text(const std::vector<T>& value, const Allowed& allowed) {
  const std::string limits = allowed_text(allowed);
  return limits.empty() ? type_text(value) : type_text(value) + ", each " + limits;
}

}  // namespace

void ConfigReader::begin_section(std::string_view name) {
  section_ = name;
  declared_[section_];
}

const ConfigEntry* ConfigReader::declare(std::string_view key) {
  declared_[section_].emplace(key);
  const auto& entries = document_.entries;
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const ConfigEntry& entry) {
    return entry.section == section_ && entry.key == key;
  });
  return found == entries.end() ? nullptr : &*found;
}

template <class T, class Allowed>
void ConfigReader::read_value(std::string_view key, T& value, const Allowed& allowed) {
  const ConfigEntry* entry = declare(key);
  if (entry == nullptr) return;
  T converted{};
  if (convert(entry->value, converted) && is_allowed(converted, allowed)) {
    value = converted;
    return;
  }
  errors_.push_back({entry->value_place, fmt::format("[{}] {} = {}: expected {}", section_, key,
                                                     entry->value_text, expected_text(value, allowed))});
}

void ConfigReader::read(std::string_view key, bool& value, YesNo allowed) { read_value(key, value, allowed); }
void ConfigReader::read(std::string_view key, int& value, Range allowed) { read_value(key, value, allowed); }
void ConfigReader::read(std::string_view key, double& value, Range allowed) {
  read_value(key, value, allowed);
}
void ConfigReader::read(std::string_view key, std::string& value, AnyText allowed) {
  read_value(key, value, allowed);
}
void ConfigReader::read(std::string_view key, std::string& value, const Choices& allowed) {
  read_value(key, value, allowed);
}
void ConfigReader::read(std::string_view key, std::vector<double>& value, Range allowed) {
  read_value(key, value, allowed);
}
void ConfigReader::read(std::string_view key, std::vector<std::string>& value, AnyText allowed) {
  read_value(key, value, allowed);
}
void ConfigReader::read(std::string_view key, std::vector<std::string>& value, const Choices& allowed) {
  read_value(key, value, allowed);
}

bool ConfigReader::is_declared_or_parent(const std::string& section) const {
  if (declared_.contains(section)) return true;
  const auto child = declared_.lower_bound(section + ".");
  return child != declared_.end() && child->first.starts_with(section + ".");
}

void ConfigReader::find_unknown_sections() {
  std::set<std::string> known;
  for (const auto& [name, keys] : declared_) known.insert(name);
  for (const ConfigSection& section : document_.sections) {
    if (is_declared_or_parent(section.name)) continue;
    const std::string hint =
        known.empty() ? "" : fmt::format("; the nearest is [{}]", nearest_name(section.name, known));
    errors_.push_back({section.place, fmt::format("unknown section [{}]{}", section.name, hint)});
  }
}

void ConfigReader::find_unknown_keys() {
  for (const ConfigEntry& entry : document_.entries) {
    if (entry.section.empty()) {
      const std::string expected = is_declared_or_parent(entry.key)
                                       ? fmt::format("a section, [{}]", entry.key)
                                       : "every key inside a [section]";
      errors_.push_back(
          {entry.key_place, fmt::format("{} = {}: expected {}", entry.key, entry.value_text, expected)});
      continue;
    }
    const auto section = declared_.find(entry.section);
    const bool known = section != declared_.end() && section->second.contains(entry.key);
    // What stands in an unknown section is reported with the section.
    if (known || !is_declared_or_parent(entry.section)) continue;
    const bool has_keys = section != declared_.end() && !section->second.empty();
    const std::string hint =
        has_keys ? fmt::format("; the nearest is \"{}\"", nearest_name(entry.key, section->second)) : "";
    errors_.push_back({entry.key_place, fmt::format("[{}] {} = {}: unknown key{}", entry.section, entry.key,
                                                    entry.value_text, hint)});
  }
}

void ConfigReader::finish() {
  find_unknown_sections();
  find_unknown_keys();
  if (errors_.empty()) return;
  std::stable_sort(errors_.begin(), errors_.end(),
                   [](const Error& a, const Error& b) { return a.place < b.place; });
  std::string message;
  for (const auto& [place, text] : errors_) {
    message += fmt::format("{}{}:{}:{}: {}", message.empty() ? "" : "\n", document_.file_name, place.line,
                           place.column, text);
  }
  throw FatalError(kExitConfiguration, message);
}

}  // namespace hindsight
