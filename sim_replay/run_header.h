// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hindsight {

/// The first event of a run log: all that a replay needs besides samples.
struct RunHeader {
  std::int64_t utime_us = 0;          ///< when the run began, UNIX time
  bool ticks_recorded = true;         ///< false: an imported recording, samples without tick events
  std::string build_id;               ///< of the program that recorded
  std::string configuration;          ///< TOML, exactly as --print-config prints it; empty in an imported log
  std::string dbc;                    ///< text of the CAN protocol's DBC file
  std::string calibration;            ///< text of the camera's calibration, OpenCV's YAML
  std::vector<std::uint8_t> mixture;  ///< the terrain mixture's state at the start of the run; may be empty
};

}  // namespace hindsight
