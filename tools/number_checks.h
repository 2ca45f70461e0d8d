// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Checks of numbers on the command line. CLI11's own print all 300 digits of their range, and let NaN pass.
#pragma once

#include <CLI/CLI.hpp>

namespace hindsight::tools {

CLI::Validator above_zero();
CLI::Validator zero_or_above();

}  // namespace hindsight::tools
