// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "planning/grid_graph.h"

#include <algorithm>
#include <cassert>

namespace hindsight {

GridGraph::GridGraph(int width, int height)
    : width_(width),
      height_(height),
      reciprocal_((std::uint64_t{1} << 40U) / static_cast<std::uint64_t>(width) + 1),
      costs_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kFreeCost),
      steps_(costs_.size(), 0),
      free_(static_cast<std::size_t>(width + 2) * static_cast<std::size_t>(height + 2), 0) {
  for (std::size_t d = 0; d < kSteps; ++d) offsets_[d] = kStepY[d] * width + kStepX[d];
  for (int y = 0; y < height; ++y) std::fill_n(&free_[padded(y, 0)], width, std::uint8_t{1});
  update_all_steps();
}

void GridGraph::init(std::span<const TraversalCost> costs) {
  assert(costs.size() == costs_.size());
  std::copy(costs.begin(), costs.end(), costs_.begin());
  for (int y = 0; y < height_; ++y) {
    const TraversalCost* from = &costs_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_)];
    std::transform(from, from + width_, &free_[padded(y, 0)],
                   [](TraversalCost c) { return static_cast<std::uint8_t>(c != kLethalCost); });
  }
  update_all_steps();
}

void GridGraph::set_cost(int cell, TraversalCost cost) {
  costs_[static_cast<std::size_t>(cell)] = cost;
  free_[padded(row(cell), column(cell))] = static_cast<std::uint8_t>(cost != kLethalCost);
}

void GridGraph::update_steps_around(int cell) {
  const int y = row(cell), x = column(cell);
  for (int j = std::max(0, y - 1); j <= std::min(height_ - 1, y + 1); ++j)
    update_steps(j, std::max(0, x - 1), std::min(width_ - 1, x + 1));
}

void GridGraph::update_all_steps() {
  for (int y = 0; y < height_; ++y) update_steps(y, 0, width_ - 1);
}

void GridGraph::update_steps(int row, int first_column, int last_column) {
  const std::uint8_t* here = &free_[padded(row, 0)];
  const std::uint8_t* north = &free_[padded(row + 1, 0)];
  const std::uint8_t* south = &free_[padded(row - 1, 0)];
  std::uint8_t* out = &steps_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_)];
  for (int x = first_column; x <= last_column; ++x) {
    const int e = here[x + 1], n = north[x], w = here[x - 1], s = south[x];
    const int straight = e | n << 1 | w << 2 | s << 3;
    const int diagonal = (north[x + 1] & n & e) << 4 | (north[x - 1] & n & w) << 5 |
                         (south[x - 1] & s & w) << 6 | (south[x + 1] & s & e) << 7;
    out[x] = static_cast<std::uint8_t>((straight | diagonal) & -here[x]);
  }
}

}  // namespace hindsight
