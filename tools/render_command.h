// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "tools/commands.h"

namespace hindsight::tools {

/// hindsight render: frames of a drive along a simulated trail, with the true label of every pixel.
void add_render(CLI::App& app, Run& run);

}  // namespace hindsight::tools
