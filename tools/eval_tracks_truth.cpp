// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/eval_tracks_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "config/exit_code.h"
#include "sim_replay/read_file.h"

namespace hindsight::tools {
namespace {

constexpr std::size_t kBoxColumns = 4, kFewestMotColumns = 6;

/// Numbers between commas or blanks; empty if any of them is none.
std::vector<double> numbers_of(std::string line) {
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == ',' || c == ';' || c == '\t' || c == '\r'; }, ' ');
  std::istringstream words(line);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return {};
    numbers.push_back(value);
  }
  return numbers;
}

bool blank(const std::string& line) { return line.find_first_not_of(" \t\r") == std::string::npos; }

cv::Rect2d box_of(const std::vector<double>& numbers, std::size_t from, double scale) {
  return {numbers[from] * scale, numbers[from + 1] * scale, numbers[from + 2] * scale,
          numbers[from + 3] * scale};
}

void warn_of_length(const std::filesystem::path& file, std::size_t lines, int frames) {
  if (lines == static_cast<std::size_t>(frames)) return;
  fmt::print(stderr, "hindsight: {}: {} lines for {} frames: {}\n", file.string(), lines, frames,
             lines < static_cast<std::size_t>(frames) ? "the frames without a line are not judged"
                                                      : "the lines without a frame are left out");
}

}  // namespace

TrackTruth read_track_truth(const std::filesystem::path& file, double scale, int frames) {
  std::istringstream text(read_file<std::string>(file));
  TrackTruth truth;
  std::size_t columns = 0, number = 0, rows = 0;
  bool anything = false;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (blank(line)) continue;
    const std::vector<double> numbers = numbers_of(line);
    if (columns == 0) columns = numbers.size();
    const bool boxes = numbers.size() == kBoxColumns && columns == kBoxColumns;
    if (!boxes && (numbers.size() < kFewestMotColumns || columns < kFewestMotColumns)) {
      throw FatalError(kExitBadData, fmt::format("{}:{}: expected x,y,w,h, or frame,id,x,y,w,h in all lines",
                                                 file.string(), number));
    }
    if (boxes) {
      ++rows;
      if (truth.frames.size() == static_cast<std::size_t>(frames)) continue;
      truth.frames.emplace_back();
      const cv::Rect2d box = box_of(numbers, 0, scale);
      if (std::isnan(box.x + box.y + box.width + box.height)) continue;
      truth.frames.back().push_back({1, box, true});
      anything = true;
      continue;
    }
    const cv::Rect2d box = box_of(numbers, 2, scale);
    const double frame = numbers[0];
    if (!(frame >= 1.0 && frame <= 1e7) || !std::isfinite(box.x + box.y + box.width + box.height)) {
      throw FatalError(kExitBadData, fmt::format("{}:{}: expected a frame from 1 on and finite numbers",
                                                 file.string(), number));
    }
    anything = true;
    if (frame > frames) continue;
    if (truth.frames.empty()) truth.frames.resize(static_cast<std::size_t>(frames));
    const bool counts = numbers.size() == kFewestMotColumns || numbers[kFewestMotColumns] != 0.0;
    truth.frames[static_cast<std::size_t>(frame) - 1].push_back({static_cast<int>(numbers[1]), box, counts});
  }
  if (columns == kBoxColumns) warn_of_length(file, rows, frames);
  truth.complete = columns != kBoxColumns || !anything;
  if (truth.complete) truth.frames.resize(static_cast<std::size_t>(frames));
  return truth;
}

}  // namespace hindsight::tools
