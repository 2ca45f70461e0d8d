// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planning/bucket_queue.h"
#include "planning/grid_graph.h"

namespace hindsight::tools {

/// The yardstick for D*: plain A* on the same graph (planning/grid_graph.h), from nothing each time. Bucket
/// queue, flat arrays with a border so that no step needs a bounds check, octile heuristic, visited cells
/// marked by generation.
class BucketAstar {
 public:
  BucketAstar(int width, int height);

  void set_cost(int cell, TraversalCost cost) { costs_[padded(cell)] = cost; }
  /// Cost of the best path, kUnreachable where there is none.
  PathCost search(int from, int to);
  int expansions() const { return expansions_; }

 private:
  struct Node {
    PathCost g = 0;
    std::uint32_t state = 0;  ///< 2 * generation: in the queue; 2 * generation + 1: expanded; less: not seen
  };

  std::size_t padded(int cell) const {
    return static_cast<std::size_t>((cell / width_ + 1) * stride_ + cell % width_ + 1);
  }
  void expand(int cell, PathCost best);
  void relax(int cell, PathCost g, PathCost h);

  int width_;
  int stride_;
  std::vector<TraversalCost> costs_;
  std::vector<Node> nodes_;
  BucketQueue queue_;
  std::uint32_t generation_ = 0;
  int target_row_ = 0;
  int target_column_ = 0;
  int expansions_ = 0;
};

}  // namespace hindsight::tools
