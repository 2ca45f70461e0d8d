// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The files of config/, and the course, that tools need wherever they are called from; built into the program.
#pragma once

#include <string>

#include "daemon/robot_config.h"
#include "sim_replay/world/course.h"

namespace hindsight::tools {

/// config/lagr.dbc
std::string builtin_dbc();

/// config/camera.yaml
std::string builtin_calibration();

/// sim_replay/courses/forest.toml
Course forest_course();

/// The defaults with config/thesis.toml over them: every number as the thesis has it.
Configuration thesis_configuration();

}  // namespace hindsight::tools
