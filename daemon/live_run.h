// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

namespace hindsight {

/// `hindsightd` on the vehicle.
struct LiveJob {
  std::vector<std::string> configuration_files;
  std::string record;  ///< run log to write; empty: none
};

/// Runs until SIGTERM or SIGINT; returns the exit code. FatalError at start-up: 66, 69, 78 (config/exit_code.h).
int run_live(const LiveJob& job);

}  // namespace hindsight
