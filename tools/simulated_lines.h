// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The world's end of the robot's GPIO lines: the kernel's gpio-sim chips have inputs that a program pulls.
#pragma once

#include <array>
#include <string>

#include "drivers/gpio_lines.h"

namespace hindsight::tools {

class SimulatedLines {
 public:
  /// Finds the lines that params names. FatalError(kExitNoDevice) where chip or line is absent, or the chip
  /// is not a simulated one.
  explicit SimulatedLines(const GpioParams& params);

  /// Pulls the line to the level at which the robot reads edge.active. FatalError(kExitIo) where the kernel
  /// does not take it. A line that the robot has not is left alone.
  void pull(const LineEdge& edge);

 private:
  struct Pull {
    std::string file;  ///< in sysfs; empty: not wired
    bool active_low = false;
  };
  std::array<Pull, kLineCount> pulls_;
};

}  // namespace hindsight::tools
