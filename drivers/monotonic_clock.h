// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "drivers/samples.h"

namespace hindsight {

/// The clock that live samples are stamped with: CLOCK_MONOTONIC, which is what libstdc++'s steady_clock
/// reads and what the kernel stamps video buffers and GPIO edges with.
inline Time monotonic_now() { return std::chrono::steady_clock::now().time_since_epoch(); }

}  // namespace hindsight
