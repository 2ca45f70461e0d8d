// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/motor_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string_view>

#include "config/exit_code.h"

namespace hindsight::tools {
namespace {

constexpr std::array<double MotorSample::*, 4> kFields = {&MotorSample::left_a, &MotorSample::right_a,
                                                          &MotorSample::left_mps, &MotorSample::right_mps};
constexpr std::array<const char*, 4> kRoles = {"left current", "right current", "left speed", "right speed"};
/// Where each of kFields stands in a row.
using Columns = std::array<std::optional<std::size_t>, 4>;

std::vector<std::string_view> split(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  std::vector<std::string_view> fields;
  for (std::size_t end = 0; end != std::string_view::npos;) {
    end = line.find(',');
    std::string_view field = line.substr(0, end);
    while (field.starts_with(' ')) field.remove_prefix(1);
    while (field.ends_with(' ')) field.remove_suffix(1);
    fields.push_back(field);
    if (end != std::string_view::npos) line.remove_prefix(end + 1);
  }
  return fields;
}

bool has_role(std::string_view column, std::size_t role) {
  std::string name(column);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto contains = [&name](const char* part) { return name.find(part) != std::string::npos; };
  const bool left = role % 2 == 0;
  const bool quantity = role < 2 ? contains("cur") : contains("vel") || contains("speed");
  return quantity &&
         (left ? contains("left") || name.ends_with('l') : contains("right") || name.ends_with('r'));
}

Columns find_columns(const std::string& path, std::string_view header,
                     const std::vector<std::string>& names) {
  const std::vector<std::string_view> fields = split(header);
  Columns columns;
  for (std::size_t role = 0; role < columns.size(); ++role) {
    const bool named = !names.empty();
    if (named && role >= names.size()) continue;
    const auto found = std::find_if(fields.begin(), fields.end(), [&](std::string_view field) {
      return named ? field == names[role] : has_role(field, role);
    });
    if (found != fields.end()) {
      columns[role] = static_cast<std::size_t>(found - fields.begin());
    } else if (named || role < 2) {
      const std::string wanted =
          named ? fmt::format("named \"{}\"", names[role]) : "for it; name it with --columns";
      throw FatalError(kExitBadData, fmt::format("{}:1: {}: expected a column {}; the file has: {}", path,
                                                 kRoles[role], wanted, header));
    }
  }
  return columns;
}

std::optional<double> number_of(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
  return whole ? std::optional(value) : std::nullopt;
}

MotorSample sample_of(const std::string& path, int line_number, std::string_view line,
                      const Columns& columns) {
  const std::vector<std::string_view> fields = split(line);
  MotorSample sample;
  for (std::size_t role = 0; role < columns.size(); ++role) {
    if (!columns[role]) continue;
    const std::string_view text = *columns[role] < fields.size() ? fields[*columns[role]] : "";
    const std::optional<double> value = number_of(text);
    if (!value) {
      throw FatalError(kExitBadData, fmt::format("{}:{}: {} in column {} is \"{}\"; expected a finite number",
                                                 path, line_number, kRoles[role], *columns[role] + 1, text));
    }
    sample.*kFields[role] = *value;
  }
  return sample;
}

}  // namespace

MotorRecording read_motor_csv(const std::string& path, const std::vector<std::string>& columns) {
  std::ifstream file(path);
  file.peek();  // opening a folder succeeds, reading it does not
  if (!file.is_open() || file.bad()) {
    throw FatalError(kExitNoInput, fmt::format("{}: cannot be read; expected a CSV file", path));
  }
  std::string line;
  std::getline(file, line);
  const Columns found = find_columns(path, line, columns);
  MotorRecording recording{.samples = {}, .has_speeds = found[2] && found[3]};
  for (int line_number = 2; std::getline(file, line); ++line_number) {
    recording.samples.push_back(sample_of(path, line_number, line, found));
  }
  if (recording.samples.empty()) {
    throw FatalError(kExitBadData, fmt::format("{}:2: expected at least one row of numbers", path));
  }
  return recording;
}

}  // namespace hindsight::tools
