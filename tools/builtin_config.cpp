// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/builtin_config.h"

#include "config/configuration.h"
#include "tools/embedded_config.h"

namespace hindsight::tools {

std::string builtin_dbc() { return kConfigFiles[1]; }

std::string builtin_calibration() { return kConfigFiles[2]; }

Course forest_course() { return read_course(ConfigDocument::parse(kConfigFiles[3], "forest.toml")); }

Configuration thesis_configuration() {
  Configuration configuration;
  read_configuration(configuration, ConfigDocument::parse(kConfigFiles[0], "thesis.toml"));
  return configuration;
}

}  // namespace hindsight::tools
