// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The grid as a graph: cells with traversal costs, 8 steps from each, no corner cutting (planning/dstar.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

namespace hindsight {

/// What crossing a cell costs: 1 (free) to kHighestCost, or kLethalCost (impassable).
using TraversalCost = std::uint8_t;
constexpr TraversalCost kFreeCost = 1;
constexpr TraversalCost kHighestCost = 60;
constexpr TraversalCost kLethalCost = 255;

/// Cost of a path, in 1/kCellUnit of a straight step between free cells.
using PathCost = std::uint32_t;
constexpr PathCost kCellUnit = 816;
constexpr PathCost kUnreachable = 0x7fffffff;

struct CostChange {
  int cell = 0;
  TraversalCost cost = kFreeCost;
};

/// Steps 0-3 are straight (east, north, west, south), 4-7 diagonal (north-east, north-west, south-west,
/// south-east).
constexpr int kSteps = 8;
constexpr std::array<int, kSteps> kStepX{1, 0, -1, 0, 1, -1, -1, 1};
constexpr std::array<int, kSteps> kStepY{0, 1, 0, -1, 1, 1, -1, -1};
/// Half a step's length; times the sum of both cells' costs it is the length times their mean.
constexpr std::array<PathCost, kSteps> kHalfStep{408, 408, 408, 408, 577, 577, 577, 577};

/// Cost over (dx, dy) cells of free ground without obstacles: consistent, since no cell costs less than 1.
inline PathCost octile_cost(int dx, int dy) {
  const int a = std::abs(dx), b = std::abs(dy);
  return 816U * static_cast<PathCost>(a > b ? a : b) + 338U * static_cast<PathCost>(a > b ? b : a);
}

class GridGraph {
 public:
  /// Every cell has cost 1.
  GridGraph(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  int size() const { return width_ * height_; }
  int row(int cell) const {
    return static_cast<int>((static_cast<std::uint64_t>(cell) * reciprocal_) >> 40U);
  }
  int column(int cell) const { return cell - row(cell) * width_; }

  TraversalCost cost(int cell) const { return costs_[static_cast<std::size_t>(cell)]; }
  /// The cell that step `d` leads to.
  int neighbour(int cell, int d) const { return cell + offsets_[static_cast<std::size_t>(d)]; }
  /// Bit d is set where step d is allowed; 0 for a lethal cell.
  unsigned steps(int cell) const { return steps_[static_cast<std::size_t>(cell)]; }
  PathCost step_cost(int d, int from, int to) const {
    return kHalfStep[static_cast<std::size_t>(d)] * static_cast<PathCost>(cost(from) + cost(to));
  }

  void init(std::span<const TraversalCost> costs);
  /// steps() of the cell and its eight neighbours are out of date afterwards until update_steps_around().
  void set_cost(int cell, TraversalCost cost);
  void update_steps_around(int cell);
  void update_all_steps();

 private:
  std::size_t padded(int row, int column) const {
    return static_cast<std::size_t>(row + 1) * static_cast<std::size_t>(width_ + 2) +
           static_cast<std::size_t>(column + 1);
  }
  void update_steps(int row, int first_column, int last_column);

  int width_;
  int height_;
  std::uint64_t reciprocal_;  ///< 2^40 / width, rounded up: exact rows while width * size < 2^40
  std::array<int, kSteps> offsets_;
  std::vector<TraversalCost> costs_;
  std::vector<std::uint8_t> steps_;
  std::vector<std::uint8_t> free_;  ///< 1 where passable, with a border of 0 all around
};

}  // namespace hindsight
