// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Where the ground rises farther off, a road is wider there than one on flat ground is, and goes on above the
// flat ground's horizon. It is looked for from a hinge on, row by row, as wide as it is found: dynamic
// programming over middle and width, in which no perspective says more than that it gets narrower.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "perception/color_view.h"
#include "perception/road_color_learner.h"
#include "perception/road_colors.h"
#include "perception/road_profile.h"
#include "perception/road_search.h"

namespace hindsight {

/// A road on flat ground from where on it is looked for; rows and columns of a stored picture.
struct RoadHinge {
  float horizon = 0.0F;            ///< of the flat ground
  std::span<const SearchRow> row;  ///< from the hinge on, from near to far
  std::span<const FoundRoad> road;
};

/// No allocation after construction. Deterministic. Not thread-safe.
class RoadRise {
 public:
  /// Rows told at most.
  static constexpr std::size_t kMostTold = 14;
  /// Half widths that are tried.
  static constexpr std::size_t kWidths = 16;

  explicit RoadRise(int width_px);

  /// Looks for the road beyond the hinge. True where it is seen on ground that rises, so that flat ground
  /// does not explain it: rows() and roads() tell it then, from near to far, at most `most_told` of them,
  /// until the next call.
  bool find(const RoadHinge& hinge, const RoadColors& colors, const ColorView& picture,
            std::size_t most_told = kMostTold);
  std::span<const SearchRow> rows() const { return std::span(told_row_).first(told_); }
  std::span<const FoundRoad> roads() const { return std::span(told_road_).first(told_); }

 private:
  static std::size_t state(int column, std::size_t width) {
    return static_cast<std::size_t>(column) * kWidths + width;
  }
  void lay_rows(const RoadHinge& hinge, const RoadColors& colors, const ColorView& picture);
  float flat_worth(const RoadHinge& hinge) const;
  float search(const FoundRoad& start);
  void step_from(int row);
  void step_aside();
  void score(int row);
  void trace();
  void tell(std::size_t most);

  int step_px_;
  int columns_;
  int end_row_ = 0;
  std::size_t end_state_ = 0;
  std::size_t told_ = 0;
  RoadProfile profile_;
  std::vector<SearchRow> row_, told_row_;
  std::vector<FoundRoad> road_, told_road_;
  std::vector<float> best_, before_;
  std::vector<std::uint16_t> link_, from_;  ///< link_: for each row and state, the state of the row before
};

}  // namespace hindsight
