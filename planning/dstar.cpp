// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "planning/dstar.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>

namespace hindsight {

namespace {

// What the parts of a repair take, in expansions of the search from nothing (measured with
// tools/bench_dstar.cpp).
constexpr long kWorkOfLowering = 4;
constexpr long kWorkOfRaising = 8;
constexpr long kWorkOfEdit = 10;
// A repair may cost this share of the expected search from nothing before it is given up.
constexpr long kBudgetDivisor = 10;
// How many cells are looked at to estimate the size of that search.
constexpr int kProbes = 128;
// Beyond this the keys' offset could overflow.
constexpr PathCost kMaxKeyOffset = 1U << 29U;
// Set in the low half of an overconsistent cell's key: among equal first halves the underconsistent come
// first, for then the search may stop at the first overconsistent one that is no better than its target.
constexpr CellHeap::Key kOverconsistent = 0x80000000U;

}  // namespace

DStar::DStar(int width, int height)
    : graph_(width, height),
      nodes_(static_cast<std::size_t>(graph_.size())),
      marks_(nodes_.size(), 0),
      seeds_(nodes_.size(), kUnreachable),
      heap_(nodes_.size()),
      buckets_(nodes_.size()) {
  seed_list_.reserve(nodes_.size());
  edits_.reserve(nodes_.size());
  toggled_.reserve(nodes_.size());
  dirty_.reserve(nodes_.size());
}

void DStar::init(std::span<const TraversalCost> costs) {
  graph_.init(costs);
  edits_.clear();
  toggled_.clear();
  anew_ = true;
}

void DStar::set_cost(int cell, TraversalCost cost) {
  assert(cost == kLethalCost || (cost >= kFreeCost && cost <= kHighestCost));
  const TraversalCost before = graph_.cost(cell);
  if (before == cost) return;
  if (edits_.size() == nodes_.size()) {  // the same cells again and again
    update_steps_of_edits();
    edits_.clear();
    anew_ = true;
  }
  graph_.set_cost(cell, cost);
  edits_.push_back(cell);
  if ((before == kLethalCost) != (cost == kLethalCost)) toggled_.push_back(cell);
}

void DStar::set_costs(std::span<const CostChange> changes) {
  for (const CostChange& change : changes) set_cost(change.cell, change.cost);
}

void DStar::set_goal(int cell) {
  const GoalSeed seed{cell, 0};
  set_goal({&seed, 1});
}

void DStar::set_goal(std::span<const GoalSeed> seeds) {
  for (const GoalSeed& seed : seed_list_) marks(seed.cell) = 0;
  seed_list_.clear();
  for (const GoalSeed& seed : seeds) {
    PathCost& extra = seeds_[static_cast<std::size_t>(seed.cell)];
    extra = std::min(seed_cost(seed.cell), seed.extra);
    if (marks(seed.cell) == 0) seed_list_.push_back(seed);
    marks(seed.cell) = kSeedMark;
  }
  anew_ = true;
}

PathCost DStar::replan(int start) {
  expansions_ = 0;
  move_start(start);
  update_steps_of_edits();
  searched_anew_ = !repair();
  if (searched_anew_) search_anew();
  edits_.clear();
  return node(start).rhs;
}

PathCost DStar::cost_to_goal(int cell) {
  settle(cell, std::numeric_limits<long>::max());
  return node(cell).rhs;
}

int DStar::extract_path(std::span<int> path) const {
  if (start_ < 0 || node(start_).rhs == kUnreachable) return 0;
  int count = 0;
  for (int cell = start_; cell >= 0 && count < static_cast<int>(path.size()); cell = next_on_path(cell))
    path[static_cast<std::size_t>(count++)] = cell;
  return count;
}

int DStar::descend(int cell, int steps) const {
  for (int next = next_on_path(cell); next >= 0 && steps > 0; next = next_on_path(cell), --steps) cell = next;
  return cell;
}

// The neighbour through which the cell's cost comes, -1 where the cell is itself the end.
int DStar::next_on_path(int cell) const {
  PathCost best = seed_cost(cell);
  int next = -1;
  for (unsigned steps = graph_.steps(cell); steps != 0; steps &= steps - 1) {
    const int d = std::countr_zero(steps), to = graph_.neighbour(cell, d);
    const PathCost cost = node(to).g + graph_.step_cost(d, cell, to);
    if (cost >= best) continue;
    best = cost;
    next = to;
  }
  return next;
}

CellHeap::Key DStar::key(int cell) const {
  const Node& n = node(cell);
  const bool over = n.g > n.rhs;
  const PathCost value = over ? n.rhs : n.g;
  // Among equal overconsistent cells the one nearest the start first.
  const CellHeap::Key tie = over ? kOverconsistent | (kUnreachable - value) : value;
  return static_cast<CellHeap::Key>(value + heuristic(cell) + key_offset_) << 32U | tie;
}

PathCost DStar::best_of_neighbours(int cell) const {
  const unsigned allowed = graph_.steps(cell);
  if (graph_.cost(cell) == kLethalCost) return kUnreachable;
  PathCost best = seed_cost(cell);
  for (unsigned steps = allowed; steps != 0; steps &= steps - 1) {
    const int d = std::countr_zero(steps), to = graph_.neighbour(cell, d);
    best = std::min(best, node(to).g + graph_.step_cost(d, cell, to));
  }
  return best;
}

void DStar::touch(int cell) {
  touched_first_ = std::min(touched_first_, std::max(0, cell - graph_.width() - 1));
  touched_last_ = std::max(touched_last_, std::min(graph_.size() - 1, cell + graph_.width() + 1));
}

void DStar::move_start(int start) {
  if (start == start_) return;
  if (start_ >= 0) {
    key_offset_ += heuristic(start);
    // Far off all that was searched: growing the search to there is no repair.
    anew_ |= node(start).rhs == kUnreachable && node(start_).rhs != kUnreachable;
  }
  start_ = start;
  start_row_ = graph_.row(start);
  start_column_ = graph_.column(start);
  anew_ |= key_offset_ > kMaxKeyOffset;
}

void DStar::update_steps_of_edits() {
  if (toggled_.size() > nodes_.size() / 64) {
    graph_.update_all_steps();
  } else {
    for (const int cell : toggled_) graph_.update_steps_around(cell);
  }
  toggled_.clear();
}

void DStar::apply_edits() {
  dirty_.clear();
  for (const int cell : edits_) {
    const int y = graph_.row(cell), x = graph_.column(cell);
    for (int j = std::max(0, y - 1); j <= std::min(graph_.height() - 1, y + 1); ++j) {
      for (int i = std::max(0, x - 1); i <= std::min(graph_.width() - 1, x + 1); ++i) {
        const int near = j * graph_.width() + i;
        if ((marks(near) & kDirtyMark) != 0) continue;
        marks(near) |= kDirtyMark;
        dirty_.push_back(near);
      }
    }
  }
  for (const int cell : dirty_) {
    marks(cell) = static_cast<std::uint8_t>(marks(cell) & ~kDirtyMark);
    node(cell).rhs = best_of_neighbours(cell);
    update_vertex(cell);
  }
}

void DStar::update_vertex(int cell) {
  if (node(cell).g == node(cell).rhs) {
    heap_.remove(cell);
  } else {
    heap_.set(cell, key(cell));
  }
}

void DStar::lower(int cell) {
  Node& n = node(cell);
  n.g = n.rhs;
  heap_.remove(cell);
  touch(cell);
  for (unsigned steps = graph_.steps(cell); steps != 0; steps &= steps - 1) {
    const int d = std::countr_zero(steps), to = graph_.neighbour(cell, d);
    const PathCost cost = n.g + graph_.step_cost(d, cell, to);
    if (cost >= node(to).rhs) continue;
    node(to).rhs = cost;
    update_vertex(to);
  }
}

void DStar::raise(int cell) {
  Node& n = node(cell);
  const PathCost before = n.g;
  n.g = kUnreachable;
  update_vertex(cell);
  for (unsigned steps = graph_.steps(cell); steps != 0; steps &= steps - 1) {
    const int d = std::countr_zero(steps), to = graph_.neighbour(cell, d);
    if (node(to).rhs != before + graph_.step_cost(d, cell, to)) continue;
    node(to).rhs = best_of_neighbours(to);
    update_vertex(to);
  }
}

// Expands inconsistent cells, least key first, until none could still change the target's cost. False where
// that would take more than `budget`; the state then is sound but the target not settled.
bool DStar::settle(int target, long budget) {
  while (!heap_.empty()) {
    const Node& t = node(target);
    const CellHeap::Key bound =
        static_cast<CellHeap::Key>(std::min(t.g, t.rhs) + heuristic(target) + key_offset_) << 32U |
        kOverconsistent;
    const CellHeap::Entry top = heap_.top();
    if (top.key >= bound && t.g >= t.rhs) return true;
    const CellHeap::Key now = key(top.cell);
    if (top.key < now) {
      heap_.set(top.cell, now);
      continue;
    }
    if (budget <= 0) return false;
    ++expansions_;
    if (node(top.cell).g > node(top.cell).rhs) {
      lower(top.cell);
      budget -= kWorkOfLowering;
    } else {
      raise(top.cell);
      budget -= kWorkOfRaising;
    }
  }
  return true;
}

bool DStar::repair() {
  if (anew_) return false;
  const Node& start = node(start_);
  const PathCost before = std::min(start.g, start.rhs);
  const long dirty_work = static_cast<long>(edits_.size()) * kWorkOfEdit;
  if (dirty_work > expected_fresh_expansions(before) / kBudgetDivisor) return false;
  apply_edits();
  if (heap_.empty()) return true;
  // The new cost is not known yet; the least key in the queue bounds it from below.
  const auto least = static_cast<PathCost>(heap_.top().key >> 32U) - key_offset_;
  const long expected = expected_fresh_expansions(std::min(least, std::min(start.g, start.rhs)));
  return settle(start_, expected / kBudgetDivisor - dirty_work);
}

// A search from nothing expands the cells with g + h below the start's cost, `bound`. Where g has not been
// repaired the old one has to do.
long DStar::expected_fresh_expansions(PathCost bound) const {
  const int stride = std::max(1, graph_.size() / kProbes) | 1;
  long inside = 0;
  for (int cell = stride / 2; cell < graph_.size(); cell += stride)
    inside += node(cell).g != kUnreachable && node(cell).g + heuristic(cell) <= bound;
  return inside * stride;
}

}  // namespace hindsight
