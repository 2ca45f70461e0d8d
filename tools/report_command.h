// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "tools/commands.h"

namespace hindsight::tools {

/// `hindsight report`: replays a run log and writes what happened as a page with pictures.
void add_report(CLI::App& app, Run& run);

}  // namespace hindsight::tools
