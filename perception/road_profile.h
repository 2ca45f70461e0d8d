// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "perception/color_view.h"
#include "perception/road_colors.h"

namespace hindsight {

/// Along some rows of a picture: how much more each place looks like road than like what lies beside it,
/// summed from the left, so that the sum between any two columns is a difference. No allocation after
/// construction.
class RoadProfile {
 public:
  RoadProfile(int rows, int width_px);

  /// Row `index` becomes the mean over the picture's rows [top, bottom), which must not be empty.
  void fill(int index, const RoadColors& colors, const ColorView& picture, int top_px, int bottom_px);

  int width_px() const { return width_px_; }
  /// Sum over the columns [left, right); outside of the picture nothing is known, which counts 0.
  float between(int index, float left_px, float right_px) const;

  /// Sums over the columns before each, width + 1 of them.
  std::span<const float> sums(int index) const {
    const auto count = static_cast<std::size_t>(width_px_ + 1);
    return std::span(sums_).subspan(static_cast<std::size_t>(index) * count, count);
  }

 private:
  int width_px_;
  std::vector<float> sums_;  ///< width + 1 for each row
};

}  // namespace hindsight
