// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "tools/commands.h"

namespace hindsight::tools {

/// `hindsight eval`: measures parts of the system on recorded data; one sub-subcommand for each.
void add_eval(CLI::App& app, Run& run);

}  // namespace hindsight::tools
