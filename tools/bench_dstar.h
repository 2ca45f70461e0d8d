// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// How much D*'s repair saves against a good A* from nothing, and what it costs where it saves nothing. All in
// one run on one thread, so that the ratios mean the same on any machine; under ten seconds.
#pragma once

namespace hindsight::tools {

/// 500 x 500 cells. The yardstick is A* with a bucket queue, flat arrays and the octile heuristic, in the
/// same direction as D* (from the goal) and to the same cost, which is checked at every step.
struct DstarBench {
  /// Robot moving along its path, 100 edits within 6 m (30 cells) a step: median of A* over median of D*.
  double dstar_speedup_weighted = 0.0;  ///< terrain of costs 1 to 20 with obstacles
  double dstar_speedup_uniform = 0.0;   ///< cost 1 with obstacles and walls
  /// Worst step of several hostile series of edits: D* over its own search from nothing, or over A* if that
  /// is faster.
  double dstar_worst_over_scratch = 0.0;
  double repair_weighted_us = 0.0;
  double astar_weighted_us = 0.0;
  double repair_uniform_us = 0.0;
  double astar_uniform_us = 0.0;
};

/// Throws FatalError(kExitSoftware) where D* and A* disagree.
DstarBench bench_dstar();

}  // namespace hindsight::tools
