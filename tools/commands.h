// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The subcommands of the `hindsight` tool. Each add_* declares its own options on `app` and sets `run` to
// what is to be done when it was chosen; `run` returns the exit code (config/exit_code.h).
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace hindsight::tools {

using Run = std::function<int()>;

}  // namespace hindsight::tools
