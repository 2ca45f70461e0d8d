// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/track_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "config/exit_code.h"

namespace hindsight {
namespace {

enum class Values { any, level, angle_latitude, angle_longitude };

struct Column {
  std::string_view name;
  TrackRow::Cell TrackRow::*cell;  ///< null for the time
  Values values = Values::any;
};

constexpr std::array kColumns{
    Column{"time_s", nullptr},
    Column{"left_mps", &TrackRow::left_mps},
    Column{"right_mps", &TrackRow::right_mps},
    Column{"left_a", &TrackRow::left_a},
    Column{"right_a", &TrackRow::right_a},
    Column{"ir_left_m", &TrackRow::ir_left_m},
    Column{"ir_right_m", &TrackRow::ir_right_m},
    Column{"yaw_rate_radps", &TrackRow::yaw_rate_radps},
    Column{"bumper_left", &TrackRow::bumper_left, Values::level},
    Column{"bumper_right", &TrackRow::bumper_right, Values::level},
    Column{"estop", &TrackRow::estop, Values::level},
    Column{"latitude_deg", &TrackRow::latitude_deg, Values::angle_latitude},
    Column{"longitude_deg", &TrackRow::longitude_deg, Values::angle_longitude},
    Column{"goal_east_m", &TrackRow::goal_east_m},
    Column{"goal_north_m", &TrackRow::goal_north_m},
    Column{"arm", &TrackRow::arm, Values::level},
};

/// Farther from the first frame is a mistake (UNIX time, milliseconds): nanoseconds must hold it, too.
constexpr double kLongestTime_s = 1e6;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r";
  const std::size_t begin = text.find_first_not_of(blank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blank) - begin + 1);
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

std::optional<double> parse_number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

const char* what_is_wrong(Values values, double value) {
  if (values == Values::level && value != 0.0 && value != 1.0) return "is neither 0 nor 1";
  if (values == Values::angle_latitude && std::abs(value) > 90.0) return "is beyond 90 degrees";
  if (values == Values::angle_longitude && std::abs(value) > 360.0) return "is beyond 360 degrees";
  return nullptr;
}

}  // namespace

TrackCsv::TrackCsv(const std::filesystem::path& path) : path_(path.string()), file_(path) {
  if (!file_ || std::filesystem::is_directory(path)) {
    throw FatalError(kExitNoInput, fmt::format("{}: cannot open the track", path_));
  }
  read_columns();
}

bool TrackCsv::next_line() {
  while (std::getline(file_, line_)) {
    ++line_number_;
    const std::string_view text = trimmed(line_);
    if (!text.empty() && text.front() != '#') return true;
  }
  if (file_.bad()) throw FatalError(kExitIo, fmt::format("{}:{}: cannot read on", path_, line_number_));
  return false;
}

void TrackCsv::read_columns() {
  if (!next_line()) {
    throw FatalError(kExitBadData,
                     fmt::format("{}: the track is empty; its first line must name the columns", path_));
  }
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // spreadsheets write it
  if (line_.starts_with(byte_order_mark)) line_.erase(0, byte_order_mark.size());
  for (const std::string_view name : split(line_)) {
    const auto* const column =
        std::find_if(kColumns.begin(), kColumns.end(), [name](const Column& c) { return c.name == name; });
    if (column == kColumns.end()) fail(name, "no such column");
    const auto number = static_cast<std::size_t>(column - kColumns.begin());
    if (std::find(columns_.begin(), columns_.end(), number) != columns_.end()) fail(name, "named twice");
    columns_.push_back(number);
  }
  if (std::find(columns_.begin(), columns_.end(), std::size_t{0}) == columns_.end())
    fail("time_s", "the column is missing");
}

bool TrackCsv::next(TrackRow& row) {
  if (!next_line()) return false;
  row = {};
  const auto cells = split(line_);
  if (cells.size() != columns_.size()) {
    throw FatalError(kExitBadData, fmt::format("{}:{}: {} cells where the first line names {} columns", path_,
                                               line_number_, cells.size(), columns_.size()));
  }
  for (std::size_t i = 0; i < cells.size(); ++i) set_cell(row, columns_[i], cells[i]);
  check(row);
  last_time_s_ = row.time_s;
  return true;
}

void TrackCsv::set_cell(TrackRow& row, std::size_t column, std::string_view text) const {
  const auto& [name, cell, values] = kColumns[column];
  if (text.empty() && cell != nullptr) return;
  const auto value = parse_number(text);
  if (!value) fail(name, fmt::format("'{}' is not a number", text));
  if (const char* const wrong = what_is_wrong(values, *value)) fail(name, fmt::format("{} {}", text, wrong));
  if (cell == nullptr) {
    row.time_s = *value;
  } else {
    row.*cell = value;
  }
}

void TrackCsv::check(const TrackRow& row) const {
  if (last_time_s_ && row.time_s < *last_time_s_) {
    fail("time_s", fmt::format("time goes back from {} to {}", *last_time_s_, row.time_s));
  }
  if (std::abs(row.time_s) > kLongestTime_s)
    fail("time_s", fmt::format("{} is no time in seconds from the first frame", row.time_s));
  if (row.latitude_deg.has_value() != row.longitude_deg.has_value())
    fail("latitude_deg", "a fix needs both coordinates");
  if (row.goal_east_m.has_value() != row.goal_north_m.has_value())
    fail("goal_east_m", "a goal needs both coordinates");
}

void TrackCsv::fail(std::string_view column, std::string_view reason) const {
  throw FatalError(kExitBadData, fmt::format("{}:{}:{}: {}", path_, line_number_, column, reason));
}

}  // namespace hindsight
