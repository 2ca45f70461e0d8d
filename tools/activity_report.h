// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What the activity experiment found, as a table, a chart and JSON.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include "tools/experiment_activity.h"
#include "tools/experiment_output.h"

namespace hindsight::tools {

inline constexpr std::array<int, 6> kObjects{0,  5,  10,
                                             20, 40, 80};  ///< that a map was learned from; 0: no map
inline constexpr int kSingleFrames = 207;                  ///< of the video with one person

/// `worlds`: of each, "tracking" (by kObjects), "single", "registration", "roundabout",
/// "taken_for_roundabout".
void report_activity(const ActivityExperiment& experiment, const ExperimentOutput& output,
                     const std::vector<nlohmann::ordered_json>& worlds);

}  // namespace hindsight::tools
