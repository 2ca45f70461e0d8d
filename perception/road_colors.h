// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Which colours are those of the road: two histograms that forget, one of what the vehicle is known to drive
// on, one of what lies beside the road.
#pragma once

#include <cstdint>
#include <vector>

#include "perception/color_view.h"

namespace hindsight {

/// No allocation after construction. Not thread-safe. Deterministic.
class RoadColors {
 public:
  RoadColors();

  enum class Side : std::uint8_t { road, beside };

  /// Counts the pixels of columns [left, right) and rows [top, bottom), clipped to the picture, `weight`
  /// each.
  void add(Side side, const ColorView& picture, int left_px, int right_px, int top_px, int bottom_px,
           float weight);
  /// Old counts fade by this factor.
  void fade(float factor);
  void clear();
  /// Makes likelihood() out of the counts.
  void refresh();

  /// Log of how much likelier a pixel's colour is on the road than beside it, cut off and scaled to [-1, 1];
  /// 0 for a colour that was never seen.
  float likelihood(const std::uint8_t* bgr) const { return likelihood_[bin_of(bgr)]; }
  bool trained() const { return road_total_ > 0.0F && beside_total_ > 0.0F; }

 private:
  static std::size_t bin_of(const std::uint8_t* bgr);
  void smooth(const std::vector<float>& counts, std::vector<float>& smoothed);

  float road_total_ = 0.0F;
  float beside_total_ = 0.0F;
  std::vector<float> road_, beside_;
  std::vector<float> smooth_road_, smooth_beside_, scratch_;
  std::vector<float> likelihood_;
};

}  // namespace hindsight
