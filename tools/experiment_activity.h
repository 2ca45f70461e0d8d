// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What the activity map is good for (thesis 3.2, 3.3): tracking with it over the number of objects that it
// was learned from, and bringing two videos of one place together by motion alone.
#pragma once

#include <cstdint>
#include <string>

namespace hindsight::tools {

struct ActivityExperiment {
  std::string folder;
  int seeds = 20;    ///< worlds
  int frames = 300;  ///< of each world's test video
  int processes = 2;
  std::uint64_t seed = 1;  ///< of the first world
};

/// Films and writes activity.json, .md and the figures; goes on where it was stopped (activity_worlds.jsonl).
/// Returns an exit code.
int run_activity_experiment(const ActivityExperiment& experiment);

}  // namespace hindsight::tools
