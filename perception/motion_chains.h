// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Flow over several frames, from the vectors between consecutive ones: slow movers show over three frames
// what noise hides over one.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "perception/ego_motion.h"
#include "perception/flow_vector.h"

namespace hindsight {

/// Follows each corner of the newest frame back over up to kLongest frames: a vector's end in frame t-1 goes
/// on with the vector of the corner that was nearest to it there, if one lay within `reach_px`. No allocation
/// after construction. Not thread-safe.
class FlowChains {
 public:
  static constexpr int kLongest = 6;

  FlowChains(int width_px, int height_px, double reach_px, std::size_t max_vectors);

  /// The flow from the newest frame t to t-1.
  void push(std::span<const FlowVector> flow);
  void clear() { chains_.clear(); }

  /// The pairs of frames t and t-gap, of all corners that can be followed so far; index_of(i) is the i-th
  /// pair's place in the span last pushed.
  std::span<const PointPair> pairs(int gap);
  std::size_t index_of(std::size_t pair) const { return index_[pair]; }
  std::size_t size() const { return chains_.size(); }

 private:
  struct Chain {
    Point2f at_px;
    int length = 0;
    std::array<Point2f, kLongest> then_px;  ///< 1, 2 ... frames ago
  };

  void sort_into_cells();
  const Chain* nearest(Point2f at_px) const;
  std::size_t cell_of(Point2f p) const;

  double reach_px_;
  int columns_, rows_;
  std::vector<Chain> chains_, last_;
  std::vector<int> first_in_cell_;
  std::vector<int> in_cell_;  ///< indices into last_, sorted by cell
  std::vector<PointPair> pairs_;
  std::vector<std::size_t> index_;
};

}  // namespace hindsight
