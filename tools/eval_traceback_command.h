// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "tools/commands.h"

namespace hindsight::tools {

/// Declares `traceback` below the subcommand `eval`.
void add_eval_traceback(CLI::App& eval, Run& run);

}  // namespace hindsight::tools
