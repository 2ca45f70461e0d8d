// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "tools/commands.h"

namespace hindsight::tools {

/// `hindsight bench reflex`: from a bumper's edge to the zero command on the bus, through the daemon's own
/// GPIO lines, reflex and CAN socket, on a machine whose lines are the kernel's gpio-sim.
void add_bench_reflex(CLI::App& bench, Run& run);

}  // namespace hindsight::tools
