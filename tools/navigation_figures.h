// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "sim_replay/world/world.h"

namespace hindsight::tools {

/// One autonomous run.
struct NavigationRun {
  std::string arm;
  unsigned world_seed = 0;
  int start = 0;
  double seconds = 0.0;
  int touches = 0;     ///< bumper
  int ir_touches = 0;  ///< infrared alone
  bool reached = false;
  std::vector<WorldPoint> path;

  int all_touches() const { return touches + ir_touches; }
};

/// Figure 5.12: one panel an arm and world, trees as discs, paths as lines.
cv::Mat draw_paths(const std::vector<World>& worlds, const std::vector<std::string>& arms,
                   const std::vector<NavigationRun>& runs);

/// Figure 5.13: touches over time, a point a run, and the ellipse that holds 95 % of each arm.
cv::Mat draw_ellipses(const std::vector<std::string>& arms, const std::vector<NavigationRun>& runs);

}  // namespace hindsight::tools
