// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Grids for the planning tests and a plain Dijkstra to compare with: it knows nothing of
// planning/grid_graph.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>
#include <random>
#include <utility>
#include <vector>

#include "planning/dstar.h"

namespace hindsight {

struct TestGrid {
  int width = 0;
  int height = 0;
  std::vector<TraversalCost> costs;

  TestGrid(int w, int h) : width(w), height(h), costs(static_cast<std::size_t>(w * h), kFreeCost) {}
  TraversalCost& at(int x, int y) { return costs[static_cast<std::size_t>(y * width + x)]; }
  bool free(int x, int y) const {
    return x >= 0 && y >= 0 && x < width && y < height &&
           costs[static_cast<std::size_t>(y * width + x)] != kLethalCost;
  }
  int size() const { return width * height; }
};

/// Costs from every cell to the nearest seed, by Dijkstra.
inline std::vector<PathCost> dijkstra(const TestGrid& grid, const std::vector<GoalSeed>& seeds) {
  std::vector<PathCost> best(grid.costs.size(), kUnreachable);
  using Item = std::pair<PathCost, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  for (const GoalSeed& seed : seeds)
    if (grid.costs[static_cast<std::size_t>(seed.cell)] != kLethalCost) open.push({seed.extra, seed.cell});
  while (!open.empty()) {
    const auto [cost, cell] = open.top();
    open.pop();
    if (cost >= best[static_cast<std::size_t>(cell)]) continue;
    best[static_cast<std::size_t>(cell)] = cost;
    const int x = cell % grid.width, y = cell / grid.width;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if ((dx == 0 && dy == 0) || !grid.free(x + dx, y + dy)) continue;
        if (dx != 0 && dy != 0 && (!grid.free(x + dx, y) || !grid.free(x, y + dy))) continue;
        const int to = (y + dy) * grid.width + x + dx;
        const int both =
            grid.costs[static_cast<std::size_t>(cell)] + grid.costs[static_cast<std::size_t>(to)];
        open.push({cost + static_cast<PathCost>((dx != 0 && dy != 0 ? 577 : 408) * both), to});
      }
    }
  }
  return best;
}

inline int uniform_int(std::mt19937& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

enum class Layout { open, random, weighted, rooms, maze };

inline TestGrid make_grid(Layout layout, int width, int height, std::mt19937& random) {
  TestGrid grid(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      TraversalCost& cost = grid.at(x, y);
      if (layout == Layout::random && uniform_int(random, 0, 99) < 30) cost = kLethalCost;
      if (layout == Layout::weighted)
        cost = uniform_int(random, 0, 9) == 0 ? kLethalCost
                                              : static_cast<TraversalCost>(uniform_int(random, 1, 60));
      if (layout == Layout::rooms && (x % 9 == 4 || y % 9 == 4) && uniform_int(random, 0, 7) != 0)
        cost = kLethalCost;
      if (layout == Layout::maze && (x % 2 == 1 || y % 2 == 1))
        cost = (x % 2 == 1 && y % 2 == 1) || uniform_int(random, 0, 99) < 45 ? kLethalCost : kFreeCost;
    }
  }
  return grid;
}

}  // namespace hindsight
