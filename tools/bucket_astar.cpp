// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/bucket_astar.h"

#include <algorithm>

namespace hindsight::tools {

BucketAstar::BucketAstar(int width, int height)
    : width_(width),
      stride_(width + 2),
      costs_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height + 2), kLethalCost),
      nodes_(costs_.size()),
      queue_(costs_.size()) {
  for (int cell = 0; cell < width * height; ++cell) set_cost(cell, kFreeCost);
}

PathCost BucketAstar::search(int from, int to) {
  ++generation_;
  expansions_ = 0;
  const int start = static_cast<int>(padded(from)), target = static_cast<int>(padded(to));
  if (costs_[padded(from)] == kLethalCost || costs_[padded(to)] == kLethalCost) return kUnreachable;
  target_row_ = target / stride_;
  target_column_ = target % stride_;
  Node& end = nodes_[static_cast<std::size_t>(target)];
  end.g = kUnreachable;
  const PathCost h = octile_cost(start / stride_ - target_row_, start % stride_ - target_column_);
  queue_.reset(h);
  relax(start, 0, h);
  for (int cell = queue_.pop(); cell >= 0; cell = queue_.pop()) {
    if (queue_.least_key() >= end.g) break;
    expand(cell, end.g);
  }
  return end.g;
}

void BucketAstar::expand(int cell, PathCost best) {
  Node& node = nodes_[static_cast<std::size_t>(cell)];
  node.state = 2 * generation_ + 1;
  const int row = cell / stride_, dy = row - target_row_, dx = cell - row * stride_ - target_column_;
  if (node.g + octile_cost(dx, dy) >= best) return;
  ++expansions_;
  const TraversalCost* at = &costs_[static_cast<std::size_t>(cell)];
  const PathCost here = *at;
  const auto straight = [&](int offset, int x, int y) {
    if (at[offset] == kLethalCost) return;
    relax(cell + offset, node.g + 408U * (here + at[offset]), octile_cost(dx + x, dy + y));
  };
  const auto diagonal = [&](int x, int y) {
    const int offset = y * stride_ + x;
    if (at[offset] == kLethalCost || at[x] == kLethalCost || at[y * stride_] == kLethalCost) return;
    relax(cell + offset, node.g + 577U * (here + at[offset]), octile_cost(dx + x, dy + y));
  };
  straight(1, 1, 0);
  straight(-1, -1, 0);
  straight(stride_, 0, 1);
  straight(-stride_, 0, -1);
  diagonal(1, 1);
  diagonal(-1, 1);
  diagonal(-1, -1);
  diagonal(1, -1);
}

void BucketAstar::relax(int cell, PathCost g, PathCost h) {
  Node& node = nodes_[static_cast<std::size_t>(cell)];
  if (node.state >= 2 * generation_) {
    if (g >= node.g) return;
    if (node.state == 2 * generation_) {
      queue_.decrease(cell, node.g + h, g + h);
    } else {
      queue_.push(cell, g + h);
    }
  } else {
    queue_.push(cell, g + h);
  }
  node = {g, 2 * generation_};
}

}  // namespace hindsight::tools
