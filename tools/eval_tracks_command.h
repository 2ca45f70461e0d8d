// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "tools/commands.h"

namespace hindsight::tools {

/// `hindsight eval tracks`: how well what moves is found and followed.
void add_eval_tracks(CLI::App& eval, Run& run);

}  // namespace hindsight::tools
