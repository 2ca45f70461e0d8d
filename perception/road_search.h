// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The road as the best path up the picture: dynamic programming (thesis 4.1) over its middle and its width.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "perception/road_profile.h"

namespace hindsight {

/// Where the road is expected in a row; pixels of the profile.
struct ExpectedRoad {
  float middle_px = 0.0F;
  float half_width_px = 1.0F;
};

struct FoundRoad {
  float middle_px = 0.0F;
  float half_width_px = 0.0F;
  float fit = 0.0F;       ///< likelihood inside less that beside, in road widths: about 2 where all is clear
  float contrast = 0.0F;  ///< mean likelihood inside less mean beside, in [-2, 2]
};

struct RoadSearchCosts {
  float bend = 3.0F;         ///< (change of the offset from what was expected / half width)^2 from row to row
  float widen = 0.15F;       ///< for each step of width from row to row
  float stray = 0.05F;       ///< (offset / half width)^2
  float odd_width = 0.012F;  ///< (steps of width away from what was expected)^2
};

/// No allocation after construction. Not thread-safe.
class RoadSearch {
 public:
  /// Widths tried are the expected one times kWidthStep to the power -kWidthSteps to kWidthSteps.
  static constexpr int kWidthSteps = 4;
  static constexpr float kWidthStep = 1.12F;

  /// step_px: between offsets tried; most_steps: of them to each side.
  RoadSearch(int rows, int step_px, int most_steps);

  /// Rows go from near to far, expected.size() of them at most `rows`. Offsets up to `steps` (at most
  /// most_steps) to each side of what is expected are tried. Returns the rows of the best path and stays
  /// valid until the next call; total() is what it is worth.
  std::span<const FoundRoad> find(const RoadProfile& profile, std::span<const ExpectedRoad> expected,
                                  int steps, const RoadSearchCosts& costs);
  float total() const { return total_; }

 private:
  static constexpr int kWidths = 2 * kWidthSteps + 1;
  std::size_t state(int offset, int width) const {
    return static_cast<std::size_t>(offset) * kWidths + static_cast<std::size_t>(width);
  }
  void score_row(const RoadProfile& profile, int row, const ExpectedRoad& expected, int steps,
                 const RoadSearchCosts& costs);
  void step_from(int row, const ExpectedRoad& expected, int steps, const RoadSearchCosts& costs);
  void trace(const RoadProfile& profile, std::span<const ExpectedRoad> expected, int steps);

  float step_px_;
  std::size_t states_;
  float total_ = 0.0F;
  std::vector<float> fit_, best_, best_before_;
  std::vector<std::uint16_t> link_;  ///< for each row and state, the state of the row before
  std::vector<FoundRoad> found_;
};

/// The edges of a road that was found on the search's grid, each moved to where within a little way the
/// likelihood changes sides. An edge outside of the picture stays.
FoundRoad refine_road(const RoadProfile& profile, int row, const FoundRoad& road,
                      float expected_half_width_px);

/// How well a road with these edges fits a row, and how much it stands out.
FoundRoad judge_road(const RoadProfile& profile, int row, float middle_px, float half_width_px,
                     float expected_half_width_px);

}  // namespace hindsight
