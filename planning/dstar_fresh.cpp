// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// D*'s search from nothing: backward A* with a bucket queue, which leaves the state that the repairs go on
// from.
#include <algorithm>
#include <bit>
#include <limits>

#include "planning/dstar.h"

namespace hindsight {

void DStar::search_anew() {
  forget();
  push_seeds();
  PathCost& best = node(start_).rhs;
  int cell = buckets_.pop();
  for (; cell >= 0; cell = buckets_.pop()) {
    const PathCost f = node(cell).rhs + heuristic(cell);
    if (!buckets_.ready(f)) {
      buckets_.push(cell, f);
      continue;
    }
    // What cannot better the start's cost stays for later repairs.
    if (buckets_.least_key() >= best) break;
    if (f >= best) {
      buckets_.postpone(cell);
    } else {
      expand_fresh(cell);
    }
  }
  hand_over_frontier(cell);
}

void DStar::forget() {
  if (touched_last_ >= touched_first_)
    std::fill(nodes_.begin() + touched_first_, nodes_.begin() + touched_last_ + 1, Node{});
  touched_first_ = graph_.size() - 1;
  touched_last_ = 0;
  heap_.clear();
  key_offset_ = 0;
  anew_ = false;
}

void DStar::push_seeds() {
  PathCost least = kUnreachable;
  for (const GoalSeed& seed : seed_list_)
    least = std::min(least, seeds_[static_cast<std::size_t>(seed.cell)] + heuristic(seed.cell));
  buckets_.reset(least);
  for (const GoalSeed& seed : seed_list_) {
    touch(seed.cell);
    if (graph_.cost(seed.cell) == kLethalCost) continue;
    node(seed.cell).rhs = seeds_[static_cast<std::size_t>(seed.cell)];
    buckets_.push(seed.cell, node(seed.cell).rhs + heuristic(seed.cell));
  }
}

void DStar::expand_fresh(int cell) {
  ++expansions_;
  touch(cell);
  Node& n = node(cell);
  n.g = n.rhs;
  const int dy = graph_.row(cell) - start_row_, dx = graph_.column(cell) - start_column_;
  for (unsigned steps = graph_.steps(cell); steps != 0; steps &= steps - 1) {
    const int d = std::countr_zero(steps), to = graph_.neighbour(cell, d);
    Node& m = node(to);
    const PathCost cost = n.g + graph_.step_cost(d, cell, to);
    if (cost >= m.rhs) continue;
    const PathCost h =
        octile_cost(dx + kStepX[static_cast<std::size_t>(d)], dy + kStepY[static_cast<std::size_t>(d)]);
    if (m.rhs < m.g) {
      buckets_.decrease(to, m.rhs + h, cost + h);
    } else {
      buckets_.push(to, cost + h);
    }
    m.rhs = cost;
  }
}

// From here on the queue is the heap: `first`, already taken out of the buckets (-1: none), and all that is
// in them. Order inside a bucket is loose, so a cell may have come too late; settling finds it.
void DStar::hand_over_frontier(int first) {
  for (int cell = first; cell >= 0; cell = buckets_.pop()) heap_.append(cell, key(cell));
  heap_.heapify();
  settle(start_, std::numeric_limits<long>::max());
}

}  // namespace hindsight
