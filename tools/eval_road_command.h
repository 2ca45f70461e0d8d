// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "tools/commands.h"

namespace hindsight::tools {

/// hindsight eval road: how well a method finds the road in recorded frames.
void add_eval_road(CLI::App& eval, Run& run);

}  // namespace hindsight::tools
