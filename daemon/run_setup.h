// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// From files, or from a log's header, to everything that a run needs. Both ways end in the same texts, so that a
// replay builds exactly the robot that recorded.
#pragma once

#include <string>
#include <vector>

#include "daemon/robot.h"
#include "sim_replay/run_header.h"

namespace hindsight {

/// Names the program that recorded a log: version and compiler.
std::string build_id();

/// Reads configuration files over the defaults, later ones over earlier ones. Paths in a file are relative to its
/// folder. FatalError: 66 a file is absent, 78 anything in it is wrong.
Configuration load_configuration(const std::vector<std::string>& files);

/// The configuration as text that reads back to the same values.
std::string to_text(Configuration configuration);

/// The saved mixture's bytes (another copy if the newest is damaged, with a warning); empty where there is none.
std::vector<std::uint8_t> load_saved_mixture(const Configuration& configuration);

/// The configuration with the gyro bias that the last run saved in robot.state_file; as it is where there is none. So the
/// bias reaches the run log with the configuration, and a replay begins with it too.
Configuration with_saved_state(Configuration configuration);

/// All texts of a run: the configuration printed, DBC, calibration, and the saved mixture.
RunHeader load_materials(const Configuration& configuration);

/// The configuration that a log was recorded with; defaults for an imported log.
Configuration configuration_of(const RunHeader& header);

/// Parses the texts of `materials`. `name` stands for them in messages: the log's, or empty for the files' own names.
RobotSetup make_setup(const Configuration& configuration, const RunHeader& materials, const std::string& name);

}  // namespace hindsight
