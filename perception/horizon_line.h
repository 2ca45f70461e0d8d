// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The horizon as the line that best parts sky from ground (thesis 4.1, after Ettinger et al. 2003).
#pragma once

#include <cstdint>
#include <vector>

#include "perception/color_view.h"

namespace hindsight {

/// row = middle_row_px + tan_angle * (column - middle of the picture)
struct HorizonLine {
  float middle_row_px = 0.0F;
  float tan_angle = 0.0F;
  /// How much of the picture's variance the line explains, 0 to 1. Where no sky is in view the best line
  /// slides to the picture's border and explains little.
  float explained = 0.0F;
};

/// Minimises variance of blue above + variance of blue below over height and angle, coarse to fine. No
/// allocation after construction. Not thread-safe.
class HorizonFinder {
 public:
  HorizonFinder(int width_px, int height_px);

  HorizonLine find(const ColorView& picture);

 private:
  struct Moments {
    double n = 0.0, sum = 0.0, squares = 0.0;
  };
  void shrink(const ColorView& picture);
  double spread_of(float middle_row, float tan_angle) const;
  Moments above(int column, float row) const;

  int step_;
  int columns_;
  int rows_;
  std::vector<double> sums_, squares_;  ///< of each column, summed downwards; rows + 1 each
};

}  // namespace hindsight
