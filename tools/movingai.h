// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Grid maps and problems in the Moving AI Lab's benchmark format (Sturtevant, "Benchmarks for Grid-Based
// Pathfinding", 2012): 8-connected, diagonals of length sqrt(2), no corner cutting.
#pragma once

#include <filesystem>
#include <vector>

#include "planning/grid_graph.h"

namespace hindsight::tools {

struct MovingAiMap {
  int width = 0;
  int height = 0;
  std::vector<TraversalCost>
      costs;  ///< row-major as in the file: kFreeCost for '.', 'G' and 'S', else kLethalCost
};

struct MovingAiProblem {
  int start = 0;
  int goal = 0;
  double optimal_length = 0.0;  ///< in cells, as printed in the file
  bool unreachable = false;     ///< the file gives length 0 although start and goal differ: there is no way
};

/// Both throw FatalError: kExitNoInput where the file cannot be read, kExitBadData, with file and line, where
/// it is damaged. A scenario's problems must lie inside `map`.
MovingAiMap read_movingai_map(const std::filesystem::path& path);
std::vector<MovingAiProblem> read_movingai_scenario(const std::filesystem::path& path,
                                                    const MovingAiMap& map);

}  // namespace hindsight::tools
