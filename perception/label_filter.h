// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Neighbours decide together. Classes by colour alone speckle: a dark leaf has the colour of bark, a light
// patch on a trunk that of ground. An obstacle is where much of the neighbourhood looks like one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "config/params.h"
#include "perception/terrain_class.h"

namespace hindsight {

struct LabelFilterParams {
  int window_px = 9;
  double share = 0.4;

  void visit(auto&& param) {
    param("window_px", window_px, Range{1, 15},
          "side of the neighbourhood, odd; 1: every pixel alone, the thesis [px]");
    param("share", share, Range{0.01, 1.0},
          "of its pixels that must look like an obstacle for its middle to be one");
  }
};

/// One thread. Allocates at construction only.
class LabelFilter {
 public:
  /// FatalError(kExitConfiguration) for an even window.
  LabelFilter(const LabelFilterParams& params, int width_px, int height_px);

  /// Row-major labels of a picture of the size given above; valid until the next call. A pixel becomes bad or
  /// lethal, whichever is more frequent (lethal where equal), if at least `share` of the window around it is
  /// one of the two; else one that was becomes unknown. The picture's edge rows and columns are repeated
  /// outwards.
  std::span<const TerrainClass> smooth(std::span<const TerrainClass> labels);

 private:
  void add_row(std::span<const TerrainClass> labels, int row, bool remove);
  void sum_across();
  void decide(const TerrainClass* labels, TerrainClass* out) const;

  int radius_px_;
  int width_px_;
  int height_px_;
  std::uint16_t fewest_;                ///< pixels of the window
  std::vector<std::uint16_t> columns_;  ///< of the window's rows: obstacles + 256 * lethal ones; padded
  std::vector<std::uint16_t> sums_;     ///< the same over the whole window
  std::vector<TerrainClass> smoothed_;
};

}  // namespace hindsight
