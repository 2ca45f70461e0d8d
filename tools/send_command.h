// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "tools/commands.h"

namespace hindsight::tools {

/// `hindsight send`: an operator's command to a running daemon.
void add_send(CLI::App& app, Run& run);

}  // namespace hindsight::tools
