// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Look-up table from pixel to the flat ground (thesis 5.1).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "perception/camera_model.h"
#include "perception/pose.h"

namespace hindsight {

/// A point of the ground in B: x forward, y left. NaN, NaN where a pixel sees no ground.
struct GroundPoint {
  float x_m = 0.0F;
  float y_m = 0.0F;
};

/// Where the ray of a pixel meets the plane z = 0 of B; empty at and above the horizon.
std::optional<Point2> ground_point(const CameraModel& camera, ImagePoint pixel);

/// Made once from a calibration; const afterwards, so any thread may read.
class GroundPlane {
 public:
  /// Ground farther than max_range_m from B's origin is left out of the table (NaN).
  GroundPlane(const CameraModel& camera, double max_range_m);

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }
  /// Of the pixel's centre.
  GroundPoint at(int column, int row) const { return table_[index(column, row)]; }
  /// Row-major, width x height.
  std::span<const GroundPoint> table() const { return table_; }
  /// One row a column: where the column crosses the horizon, between -0.5 (all of it sees ground) and height
  /// - 0.5 (none of it does). For drawing.
  std::span<const float> horizon_row_px() const { return horizon_row_px_; }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_px_) +
           static_cast<std::size_t>(column);
  }
  int width_px_;
  int height_px_;
  std::vector<GroundPoint> table_;
  std::vector<float> horizon_row_px_;
};

}  // namespace hindsight
