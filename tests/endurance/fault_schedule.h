// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim_replay/sample_faults.h"

namespace hindsight::endurance {

/// Faults of any source and kind, drawn by chance, one after the other with time between to get under way
/// again; all end before `drive`. The same seed gives the same.
std::vector<FaultSpec> draw_faults(std::uint64_t seed, Time drive);

/// As `hindsightd --replay --inject` takes it.
std::string text_of(const FaultSpec& fault);

}  // namespace hindsight::endurance
