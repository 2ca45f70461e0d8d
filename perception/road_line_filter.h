// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace hindsight {

/// The road's middle line and width over time: in each of some rows a Kalman filter of the middle and of the
/// width's ratio to what is expected there, in which no edge moves far at once. Rows are tied together by
/// what is measured (the path is smooth), not by the filter. No allocation after construction.
class RoadLineFilter {
 public:
  explicit RoadLineFilter(int rows);

  /// Forgets everything: the next correction is taken as it is.
  void reset();
  /// All rows move aside by `dx_px` and become uncertain: `sigma` in half widths.
  void predict(float dx_px, float sigma);
  /// A measurement in one row with its standard deviation in half widths.
  void correct(int row, float middle_px, float half_width_px, float expected_half_width_px, float sigma);

  /// What a row was is not known any more.
  void forget(int row) { states_[static_cast<std::size_t>(row)] = {}; }

  bool known(int row) const { return states_[static_cast<std::size_t>(row)].known; }
  float middle_px(int row) const { return states_[static_cast<std::size_t>(row)].middle_px; }
  /// Of the expected half width.
  float width_ratio(int row) const { return states_[static_cast<std::size_t>(row)].width_ratio; }

 private:
  struct State {
    bool known = false;
    float middle_px = 0.0F;
    float width_ratio = 1.0F;
    float variance = 0.0F;  ///< in half widths squared, of both
  };
  std::vector<State> states_;
};

}  // namespace hindsight
