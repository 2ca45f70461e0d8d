// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "tools/commands.h"

namespace hindsight::tools {

/// `hindsight eval slip --csv FILE... --rate HZ [--columns NAMES] [--json]`: how often the slip detector
/// speaks on recorded motor currents, with the default parameters and with the thesis'. JSON: {"hours",
/// "detections", "per_hour", "thesis": {the same}}.
void add_eval_slip(CLI::App& eval, Run& run);

}  // namespace hindsight::tools
