// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/simulated_lines.h"

#include <fmt/format.h>
#include <glob.h>
#include <gpiod.h>

#include <fstream>
#include <memory>

#include "config/exit_code.h"

namespace hindsight::tools {
namespace {

struct ChipCloser {
  void operator()(gpiod_chip* chip) const { gpiod_chip_close(chip); }
};
using Chip = std::unique_ptr<gpiod_chip, ChipCloser>;

/// The first path that fits, or empty.
std::string find_path(const std::string& pattern) {
  glob_t found{};
  std::string path;
  if (glob(pattern.c_str(), 0, nullptr, &found) == 0) path = found.gl_pathv[0];
  globfree(&found);
  return path;
}

}  // namespace

SimulatedLines::SimulatedLines(const GpioParams& params) {
  const Chip chip(gpiod_chip_open_lookup(params.chip.c_str()));
  if (!chip) throw FatalError(kExitNoDevice, params.chip + ": no such GPIO chip");
  const auto wire = [&](Line which, const std::string& name, bool active_low) {
    if (name.empty()) return;
    gpiod_line* line = find_gpio_line(chip.get(), name);
    if (line == nullptr)
      throw FatalError(kExitNoDevice, fmt::format("{}: the GPIO chip has no line '{}'", params.chip, name));
    const std::string file = find_path(fmt::format("/sys/devices/platform/gpio-sim.*/{}/sim_gpio{}/pull",
                                                   gpiod_chip_name(chip.get()), gpiod_line_offset(line)));
    if (file.empty())
      throw FatalError(kExitNoDevice,
                       params.chip + ": not a simulated GPIO chip (gpio-sim): nothing pulls its lines");
    pulls_[static_cast<std::size_t>(which)] = {file, active_low};
  };
  wire(Line::bumper_left, params.bumper_left, params.bumpers_active_low);
  wire(Line::bumper_right, params.bumper_right, params.bumpers_active_low);
  wire(Line::estop, params.estop, params.estop_active_low);
}

void SimulatedLines::pull(const LineEdge& edge) {
  const Pull& pull = pulls_[static_cast<std::size_t>(edge.line)];
  if (pull.file.empty()) return;
  std::ofstream file(pull.file);
  file << (edge.active != pull.active_low ? "pull-up" : "pull-down") << std::flush;
  if (!file) throw FatalError(kExitIo, pull.file + ": the line cannot be pulled");
}

}  // namespace hindsight::tools
