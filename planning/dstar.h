// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Incremental shortest paths on a grid (thesis 5.1, "D*"): D* Lite of Koenig and Likhachev (AAAI 2002),
// optimized version, backwards from the goal, so that only what a change near the robot affects is searched
// again.
//
// Grid: width x height cells, row-major (index = row * width + column), 8-connected. A diagonal step needs
// both cells beside it free (no corner cutting). Costs are integers: a step from a to b costs its length
// times the mean of the two cells' costs, in units of 1/kCellUnit of a straight step between two cells of
// cost 1; 408 : 577 is the square root of two to 1.5e-6. The same on every machine.
//
// A repair that grows to more than a fraction of what a search from nothing is expected to take is given up
// in favour of just that (A* with a bucket queue, dstar_fresh.cpp), so no change of the map costs much more
// than planning anew.
//
// All memory is reserved at construction. Not thread-safe; pure (no clock, no randomness).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planning/bucket_queue.h"
#include "planning/cell_heap.h"
#include "planning/grid_graph.h"

namespace hindsight {

/// A cell from which the goal can be reached outside this search for `extra`: the goal itself (0), or a
/// border cell with the heuristic cost from there to a goal beyond the local map (thesis 5.2.4).
struct GoalSeed {
  int cell = 0;
  PathCost extra = 0;
};

class DStar {
 public:
  /// Every cell starts with cost 1, and there is no goal.
  DStar(int width, int height);

  /// Replaces all costs (width * height) and forgets all that was searched.
  void init(std::span<const TraversalCost> costs);

  /// A cell's new cost: 1..kHighestCost or kLethalCost. Takes effect with the next replan().
  void set_cost(int cell, TraversalCost cost);
  void set_costs(std::span<const CostChange> changes);

  /// New goal: one cell, or several with extra costs; the next replan() searches anew.
  void set_goal(int cell);
  void set_goal(std::span<const GoalSeed> seeds);

  /// Makes the cost from `start` exact and returns it; kUnreachable where there is no way, or where the start
  /// is lethal.
  PathCost replan(int start);

  /// Exact cost from any cell to the goal, on the map of the last replan(); searches on until it is settled.
  PathCost cost_to_goal(int cell);

  /// Fills `path` with the cells from the last start to the goal, both included, as far as they fit; returns
  /// how many were written, 0 where there is no way.
  int extract_path(std::span<int> path) const;

  /// Where the best path from a cell whose cost_to_goal() is exact has led after so many steps (or its end).
  int descend(int cell, int steps) const;

  int width() const { return graph_.width(); }
  int height() const { return graph_.height(); }
  TraversalCost cost(int cell) const { return graph_.cost(cell); }

  /// Cells expanded by the last replan() and by cost_to_goal() since.
  int expansions() const { return expansions_; }
  /// Whether the last replan() ended up searching from nothing.
  bool searched_anew() const { return searched_anew_; }

 private:
  /// A cell is consistent where g == rhs, else it is in the queue (the paper's names and invariants).
  struct Node {
    PathCost g = kUnreachable;
    PathCost rhs = kUnreachable;
  };

  static constexpr std::uint8_t kSeedMark = 1;
  static constexpr std::uint8_t kDirtyMark = 2;

  std::uint8_t& marks(int cell) { return marks_[static_cast<std::size_t>(cell)]; }
  /// What the cell's being a seed offers: its extra cost.
  PathCost seed_cost(int cell) const {
    const auto i = static_cast<std::size_t>(cell);
    return (marks_[i] & kSeedMark) != 0 ? seeds_[i] : kUnreachable;
  }
  Node& node(int cell) { return nodes_[static_cast<std::size_t>(cell)]; }
  const Node& node(int cell) const { return nodes_[static_cast<std::size_t>(cell)]; }
  PathCost heuristic(int cell) const {
    const int y = graph_.row(cell);
    return octile_cost(cell - y * graph_.width() - start_column_, y - start_row_);
  }
  CellHeap::Key key(int cell) const;
  PathCost best_of_neighbours(int cell) const;
  int next_on_path(int cell) const;
  void touch(int cell);
  void move_start(int start);

  // Repair (dstar.cpp). Work is counted in expansions of the search from nothing.
  void update_steps_of_edits();
  void apply_edits();
  void update_vertex(int cell);
  void lower(int cell);
  void raise(int cell);
  bool settle(int target, long budget);
  bool repair();
  long expected_fresh_expansions(PathCost bound) const;

  // Search from nothing (dstar_fresh.cpp).
  void search_anew();
  void forget();
  void push_seeds();
  void expand_fresh(int cell);
  void hand_over_frontier(int first);

  GridGraph graph_;
  std::vector<Node> nodes_;
  std::vector<std::uint8_t> marks_;  ///< kSeedMark, kDirtyMark
  std::vector<PathCost> seeds_;      ///< extra cost of a marked seed cell
  std::vector<GoalSeed> seed_list_;
  CellHeap heap_;
  BucketQueue buckets_;
  std::vector<int> edits_;    ///< cells whose cost changed since the last replan()
  std::vector<int> toggled_;  ///< those of them that became lethal or passable
  std::vector<int> dirty_;    ///< edited cells and their neighbours, each once
  bool anew_ = true;          ///< nothing to repair: search from nothing
  int start_ = -1;
  int start_row_ = 0;
  int start_column_ = 0;
  PathCost key_offset_ = 0;  ///< the paper's k_m
  int touched_first_ = 0;    ///< every cell that is not as at construction lies in [first, last]
  int touched_last_ = -1;
  int expansions_ = 0;
  bool searched_anew_ = false;
};

}  // namespace hindsight
