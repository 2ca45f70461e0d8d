// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/bench_dstar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

#include "config/exit_code.h"
#include "planning/dstar.h"
#include "tools/bucket_astar.h"
#include "tools/cpu_time.h"

namespace hindsight::tools {

namespace {

constexpr int kSide = 500;
constexpr int kCells = kSide * kSide;
constexpr int kReach = 30;  // 6 m of 20 cm cells
constexpr int kSteps = 120;
constexpr int kEdits = 100;
constexpr int kStart = 20 * kSide + 20;
constexpr int kGoal = (kSide - 20) * kSide + kSide - 20;

using Costs = std::vector<TraversalCost>;
using Random = std::mt19937;

int below(Random& random, int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); }
int cell_at(int x, int y) { return y * kSide + x; }
TraversalCost& at(Costs& costs, int cell) { return costs[static_cast<std::size_t>(cell)]; }
TraversalCost weight(Random& random) { return static_cast<TraversalCost>(1 + below(random, 20)); }

// Hills of cost 1 to 20 about 25 cells wide, roughened, with one cell in twelve lethal.
Costs weighted_terrain(Random& random) {
  constexpr int kLattice = 25, kKnots = kSide / kLattice + 1;
  std::vector<int> knots(kKnots * kKnots);
  for (int& knot : knots) knot = below(random, 17);
  const auto knot = [&](int i, int j) { return knots[static_cast<std::size_t>(j * kKnots + i)]; };
  Costs costs(kCells);
  for (int cell = 0; cell < kCells; ++cell) {
    const int x = cell % kSide, y = cell / kSide;
    const int i = x / kLattice, j = y / kLattice, u = x % kLattice, v = y % kLattice;
    const int south = knot(i, j) * (kLattice - u) + knot(i + 1, j) * u;
    const int north = knot(i, j + 1) * (kLattice - u) + knot(i + 1, j + 1) * u;
    const int hill = (south * (kLattice - v) + north * v) / (kLattice * kLattice);
    at(costs, cell) =
        below(random, 12) == 0 ? kLethalCost : static_cast<TraversalCost>(1 + hill + below(random, 4));
  }
  return costs;
}

// Free ground, one cell in six lethal, and long walls with a gap each.
Costs uniform_terrain(Random& random) {
  Costs costs(kCells, kFreeCost);
  for (TraversalCost& cost : costs)
    if (below(random, 6) == 0) cost = kLethalCost;
  for (int x = 60; x < kSide - 30; x += 60) {
    const int gap = below(random, kSide - 20);
    for (int y = 0; y < kSide; ++y)
      if (y < gap || y >= gap + 20) at(costs, cell_at(x, y)) = kLethalCost;
  }
  return costs;
}

// Both planners on the same map; edits are collected in `changes` for D*, whose taking them in is timed.
struct Arena {
  explicit Arena(Costs terrain) : costs(std::move(terrain)), dstar(kSide, kSide), astar(kSide, kSide) {
    at(costs, kStart) = at(costs, kGoal) = kFreeCost;
    dstar.init(costs);
    dstar.set_goal(kGoal);
    for (int cell = 0; cell < kCells; ++cell) astar.set_cost(cell, at(costs, cell));
  }
  void set(int cell, TraversalCost cost) {
    if (cell == robot || cell == kGoal) return;
    at(costs, cell) = cost;
    astar.set_cost(cell, cost);
    changes.push_back({cell, cost});
  }
  void check(PathCost found, PathCost expected) const {
    if (found == expected) return;
    throw FatalError(kExitSoftware,
                     fmt::format("bench: D* found a path of cost {}, A* one of {}", found, expected));
  }

  Costs costs;
  DStar dstar;
  BucketAstar astar;
  std::vector<CostChange> changes;
  int robot = kStart;
};

// As many cells become lethal as are freed; on weighted ground three edits of four change a weight.
void edit_near(Arena& arena, Random& random, bool weighted) {
  const int x = arena.robot % kSide, y = arena.robot / kSide;
  bool shut_next = false;
  for (int edits = 0; edits < kEdits;) {
    const int i = x + below(random, 2 * kReach + 1) - kReach, j = y + below(random, 2 * kReach + 1) - kReach;
    if (i < 0 || j < 0 || i >= kSide || j >= kSide || std::max(std::abs(i - x), std::abs(j - y)) < 2)
      continue;
    const int cell = cell_at(i, j);
    const bool lethal = at(arena.costs, cell) == kLethalCost;
    const bool reweigh = weighted && edits % 4 != 0;
    if (lethal != (!reweigh && !shut_next)) continue;
    if (reweigh) {
      arena.set(cell, weight(random));
    } else {
      arena.set(cell, shut_next ? kLethalCost : weighted ? weight(random) : kFreeCost);
      shut_next = !shut_next;
    }
    ++edits;
  }
}

struct Medians {
  double repair_us = 0.0;
  double astar_us = 0.0;
};

Medians drive(Costs terrain, Random& random, bool weighted) {
  Arena arena(std::move(terrain));
  arena.dstar.replan(arena.robot);
  std::vector<double> repair_us, astar_us;
  std::vector<int> path(2);
  for (int step = 0; step < kSteps; ++step) {
    if (arena.dstar.extract_path(path) == 2) arena.robot = path[1];
    arena.changes.clear();
    edit_near(arena, random, weighted);
    PathCost found = 0, expected = 0;
    repair_us.push_back(microseconds([&] {
      arena.dstar.set_costs(arena.changes);
      found = arena.dstar.replan(arena.robot);
    }));
    astar_us.push_back(microseconds([&] { expected = arena.astar.search(kGoal, arena.robot); }));
    arena.check(found, expected);
  }
  return {quantile(repair_us, 0.5), quantile(astar_us, 0.5)};
}

using Hostile = std::function<void(Arena&, Random&, int step)>;

void edit_anywhere(Arena& arena, Random& random, int count, int from, int side) {
  for (int k = 0; k < count; ++k)
    arena.set(cell_at(from + below(random, side), from + below(random, side)),
              below(random, 6) == 0 ? kLethalCost : weight(random));
}

void wall(Arena& arena, int x, int gap) {
  for (int y = 0; y < kSide; ++y) arena.set(cell_at(x, y), std::abs(y - gap) < 5 ? kFreeCost : kLethalCost);
}

// Near the goal; in the middle; all over; the whole map; walls whose only gap jumps, near either end; a wall
// across that opens and shuts.
const Hostile kHostile[] = {
    [](Arena& a, Random& r, int) { edit_anywhere(a, r, 100, 440, 40); },
    [](Arena& a, Random& r, int) { edit_anywhere(a, r, 3, 460, 30); },
    [](Arena& a, Random& r, int) { edit_anywhere(a, r, 500, 200, 100); },
    [](Arena& a, Random& r, int) { edit_anywhere(a, r, 20000, 0, kSide); },
    [](Arena& a, Random& r, int) { edit_anywhere(a, r, 2 * kCells, 0, kSide); },
    [](Arena& a, Random&, int step) { wall(a, 40, step % 2 == 0 ? 480 : 20); },
    [](Arena& a, Random&, int step) { wall(a, 460, step % 2 == 0 ? 480 : 20); },
    [](Arena& a, Random&, int step) { wall(a, 250, step % 2 == 0 ? -100 : 250); },
};
constexpr int kHostileSteps = 4;

double replan_us(const DStar& before, DStar& trial, const Arena& arena, bool anew, PathCost& cost) {
  trial = before;
  if (anew) trial.set_goal(kGoal);
  return microseconds([&] {
    trial.set_costs(arena.changes);
    cost = trial.replan(arena.robot);
  });
}

// The least of several measurements each, and of more where the ratio looks bad: a neighbour's load only ever
// adds.
double worst_of(const Hostile& series, const Costs& terrain, Random& random) {
  Arena arena(terrain);
  arena.dstar.replan(arena.robot);
  DStar trial = arena.dstar;
  double worst = 0.0;
  for (int step = 0; step < kHostileSteps; ++step) {
    arena.changes.clear();
    series(arena, random, step);
    const PathCost expected = arena.astar.search(kGoal, arena.robot);
    double anew_us = INFINITY, repair_us = INFINITY;
    for (int k = 0; k < 2 || (k < 12 && repair_us > 1.1 * anew_us); ++k) {
      PathCost cost = 0;
      anew_us = std::min(anew_us, replan_us(arena.dstar, trial, arena, true, cost));
      arena.check(cost, expected);
      repair_us = std::min(repair_us, replan_us(arena.dstar, trial, arena, false, cost));
      arena.check(cost, expected);
    }
    std::swap(arena.dstar, trial);
    worst = std::max(worst, repair_us / anew_us);
  }
  return worst;
}

}  // namespace

DstarBench bench_dstar() {
  Random random(7);
  const Costs weighted = weighted_terrain(random), uniform = uniform_terrain(random);
  const Medians w = drive(weighted, random, true), u = drive(uniform, random, false);
  DstarBench bench;
  bench.repair_weighted_us = w.repair_us;
  bench.astar_weighted_us = w.astar_us;
  bench.repair_uniform_us = u.repair_us;
  bench.astar_uniform_us = u.astar_us;
  bench.dstar_speedup_weighted = w.astar_us / w.repair_us;
  bench.dstar_speedup_uniform = u.astar_us / u.repair_us;
  for (const Hostile& series : kHostile)
    bench.dstar_worst_over_scratch =
        std::max(bench.dstar_worst_over_scratch, worst_of(series, weighted, random));
  return bench;
}

}  // namespace hindsight::tools
