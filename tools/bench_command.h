// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "tools/commands.h"

namespace hindsight::tools {

/// `hindsight bench`: each stage and the whole tick, as ratios in one run.
void add_bench(CLI::App& app, Run& run);

}  // namespace hindsight::tools
