// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "perception/flow_vector.h"
#include "perception/grey_image.h"
#include "perception/min_eigenvalue.h"
#include "perception/optical_flow_params.h"

namespace hindsight {

/// Shi-Tomasi corners: local maxima of the smaller eigenvalue of the gradient matrix (thesis 2.1), taken
/// strongest first as long as spacing and quota allow. No allocation after construction.
class CornerDetector {
 public:
  CornerDetector(const CornerParams& params, int width_px, int height_px);

  /// Corners at whole pixels, strongest first; of equal ones the upper, then the left one. Empty for an image
  /// without texture. Valid until the next call.
  std::span<const Point2f> detect(const GreyImage& grey);

 private:
  void collect_local_maxima(int y);
  float threshold() const;
  void select();
  bool quota_left(int x, int y);
  void block_around(int x, int y);

  CornerParams params_;
  int width_px_;
  int height_px_;
  MinEigenvalueRows strength_;
  std::vector<std::uint8_t> is_maximum_;   ///< of one row
  std::vector<std::uint64_t> candidates_;  ///< strength above place, so that plain order is the order wanted
  std::vector<int>
      disc_half_width_px_;  ///< of each row of the disc that a corner keeps free, from its middle on
  std::vector<std::uint8_t> blocked_;  ///< a corner is too near
  std::vector<int> taken_in_cell_;
  std::vector<Point2f> corners_;
};

}  // namespace hindsight
