// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "tools/commands.h"

namespace hindsight::tools {

/// `hindsight demo`: a run of its own in a synthetic grove, recorded as OUT/demo.lcm.
void add_demo(CLI::App& app, Run& run);

}  // namespace hindsight::tools
