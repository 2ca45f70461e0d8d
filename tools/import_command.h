// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "tools/commands.h"

namespace hindsight::tools {

/// `hindsight import`: a run log from pictures and a track.
void add_import(CLI::App& app, Run& run);

}  // namespace hindsight::tools
