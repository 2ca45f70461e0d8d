// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <vector>

#include "perception/flow_vector.h"

namespace hindsight {

/// How far things moved in the picture from one frame to the next: turning moves all of them alike, driving
/// hardly moves them.
struct FarMotion {
  float dx_px = 0.0F;
  float dy_px = 0.0F;
  int vectors = 0;  ///< 0: not known, no motion is told
};

/// Median of the flow near the horizon, as motion from the frame before to the newest one. No allocation
/// after construction.
class FarMotionFinder {
 public:
  explicit FarMotionFinder(int max_vectors);

  /// Vectors within `reach_px` of the horizon's row are taken; fewer than 8 tell nothing.
  FarMotion find(std::span<const FlowVector> flow_t_to_t_minus_1, float horizon_row_px, float reach_px);

 private:
  std::vector<float> dx_px_, dy_px_;
};

}  // namespace hindsight
