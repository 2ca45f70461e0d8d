// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/calibration_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "config/exit_code.h"
#include "sim_replay/read_file.h"

namespace hindsight {
namespace {

/// The number after `key:` at the beginning of a line. Both kinds of YAML write it so, which no single parser
/// reads.
int read_number(std::string_view text, const std::string& key, const std::string& path) {
  const std::string wanted = "\n" + key + ":";
  const std::size_t at = text.find(wanted);
  int number = 0;
  if (at != std::string_view::npos) {
    std::string_view rest = text.substr(at + wanted.size());
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    std::from_chars(rest.data(), rest.data() + rest.size(), number);
  }
  if (number <= 0)
    throw FatalError(kExitBadData, fmt::format("{}: no {} in this camera calibration", path, key));
  return number;
}

}  // namespace

CalibrationText read_calibration_text(const std::filesystem::path& path) {
  CalibrationText calibration{read_file<std::string>(path)};
  const std::string text = "\n" + calibration.text;
  calibration.width_px = read_number(text, "image_width", path.string());
  calibration.height_px = read_number(text, "image_height", path.string());
  return calibration;
}

}  // namespace hindsight
