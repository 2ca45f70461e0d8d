// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/motion_chains.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hindsight {
namespace {

constexpr float kCell_px = 8.0F;

}  // namespace

FlowChains::FlowChains(int width_px, int height_px, double reach_px, std::size_t max_vectors)
    : reach_px_(std::min(reach_px, static_cast<double>(kCell_px))),
      columns_(width_px / static_cast<int>(kCell_px) + 1),
      rows_(height_px / static_cast<int>(kCell_px) + 1),
      first_in_cell_(static_cast<std::size_t>(columns_ * rows_) + 1) {
  chains_.reserve(max_vectors), last_.reserve(max_vectors), in_cell_.reserve(max_vectors);
  pairs_.reserve(max_vectors), index_.reserve(max_vectors);
}

std::size_t FlowChains::cell_of(Point2f p) const {
  const int column = std::clamp(static_cast<int>(p.x_px / kCell_px), 0, columns_ - 1);
  const int row = std::clamp(static_cast<int>(p.y_px / kCell_px), 0, rows_ - 1);
  return static_cast<std::size_t>(row * columns_ + column);
}

void FlowChains::sort_into_cells() {
  std::fill(first_in_cell_.begin(), first_in_cell_.end(), 0);
  for (const Chain& chain : last_) ++first_in_cell_[cell_of(chain.at_px) + 1];
  std::partial_sum(first_in_cell_.begin(), first_in_cell_.end(), first_in_cell_.begin());
  in_cell_.resize(last_.size());
  // Filled from behind, so that each cell's first index is found again at its place.
  for (std::size_t i = last_.size(); i-- > 0;) {
    const std::size_t cell = cell_of(last_[i].at_px);
    in_cell_[static_cast<std::size_t>(--first_in_cell_[cell + 1])] = static_cast<int>(i);
  }
  // first_in_cell_[c + 1] is now where cell c begins.
}

const FlowChains::Chain* FlowChains::nearest(Point2f at_px) const {
  const Chain* best = nullptr;
  auto best_px2 = static_cast<float>(reach_px_ * reach_px_);
  const int column = static_cast<int>(at_px.x_px / kCell_px), row = static_cast<int>(at_px.y_px / kCell_px);
  for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r) {
    for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c) {
      const auto cell = static_cast<std::size_t>(r * columns_ + c);
      const int begin = first_in_cell_[cell + 1];
      const int end =
          cell + 2 < first_in_cell_.size() ? first_in_cell_[cell + 2] : static_cast<int>(in_cell_.size());
      for (int k = begin; k < end; ++k) {
        const Chain& chain = last_[static_cast<std::size_t>(in_cell_[static_cast<std::size_t>(k)])];
        const float dx = chain.at_px.x_px - at_px.x_px, dy = chain.at_px.y_px - at_px.y_px;
        if (dx * dx + dy * dy <= best_px2) best = &chain, best_px2 = dx * dx + dy * dy;
      }
    }
  }
  return best;
}

void FlowChains::push(std::span<const FlowVector> flow) {
  std::swap(chains_, last_);
  sort_into_cells();
  chains_.clear();
  for (const FlowVector& v : flow) {
    Chain chain{.at_px = {v.x_px, v.y_px}, .length = 1, .then_px = {}};
    const Point2f then = chain.then_px[0] = {v.x_px + v.dx_px, v.y_px + v.dy_px};
    if (const Chain* before = nearest(then)) {
      chain.length = std::min(kLongest, before->length + 1);
      const float dx = then.x_px - before->at_px.x_px, dy = then.y_px - before->at_px.y_px;
      for (int k = 1; k < chain.length; ++k) {
        const Point2f& p = before->then_px[static_cast<std::size_t>(k - 1)];
        chain.then_px[static_cast<std::size_t>(k)] = {p.x_px + dx, p.y_px + dy};
      }
    }
    chains_.push_back(chain);
  }
}

std::span<const PointPair> FlowChains::pairs(int gap) {
  pairs_.clear(), index_.clear();
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    if (chains_[i].length < gap) continue;
    pairs_.push_back({chains_[i].at_px, chains_[i].then_px[static_cast<std::size_t>(gap - 1)]});
    index_.push_back(i);
  }
  return pairs_;
}

}  // namespace hindsight
