// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "tools/commands.h"

namespace hindsight::tools {

/// Replays a run log, prints the first difference or that there is none, and returns the exit code.
int verify_run(const std::string& log);

/// `hindsight verify`: replays a recorded run and compares everything published with what the log holds.
void add_verify(CLI::App& app, Run& run);

}  // namespace hindsight::tools
