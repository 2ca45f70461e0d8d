// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>

#include "tools/commands.h"

namespace hindsight::tools {

/// How D* did on Moving AI's problems. Times are the thread's own, in microseconds.
struct PlannerEvaluation {
  int maps = 0;
  int problems = 0;
  int optimal = 0;  ///< problems whose path is as long as the file says (relative 1e-4, for it prints few
                    ///< digits), or where it says that there is none and none was found
  double median_us = 0.0;  ///< a search from nothing
  double p95_us = 0.0;
  double max_us = 0.0;
  double replan_median_us = 0.0;  ///< a repair after 10 random cells within 10 of the start were shut
  double replan_p95_us = 0.0;
  double seconds = 0.0;
};

/// At most `limit` problems (0: all), spread evenly over all maps of the folder. Throws FatalError as the
/// readers do (tools/movingai.h), and kExitNoInput where there is no folder or no map in it.
PlannerEvaluation evaluate_planner(const std::filesystem::path& folder, int limit);

/// `hindsight eval planner --maps DIR [--limit N] [--json]`; exit code 1 where a path was not optimal.
void add_eval_planner(CLI::App& eval, Run& run);

}  // namespace hindsight::tools
