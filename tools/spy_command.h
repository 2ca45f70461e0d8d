// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "tools/commands.h"

namespace hindsight::tools {

/// `hindsight spy [LCM-URL]`: becomes the program hindsight-spy that stands beside this one.
void add_spy(CLI::App& app, Run& run);

}  // namespace hindsight::tools
