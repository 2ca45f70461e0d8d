// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Where things move, how fast and which way (thesis 3.1.4).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "config/params.h"

namespace hindsight {

/// Metres here, for the daemon; where the ground's frame is a picture plane, pixels.
struct ActivityMapParams {
  double cell = 1.0;
  int cells = 256;
  double max_speed = 1.5;

  void visit(auto&& param) {
    param("cell", cell, Range{0.01, 1000.0}, "side of a cell of the activity map [m]");
    param("cells", cells, Range{8, 1024}, "cells along each side of the map");
    param("max_speed", max_speed, Range{0.001, 1000.0},
          "the last of the 30 bins of speed holds all that is faster [m/frame]");
  }
};

/// The histogram h(x, y, v, theta): 30 bins of speed and 36 of direction in each cell of the ground. The
/// ground's frame G is whatever the caller anchors it to: the picture plane of a first frame (thesis), or W.
/// Cell (0, 0) has its corner at (-size/2, -size/2) cells of G, so that G's origin is the middle.
///
/// Beside it stands the exposure: in how many frames each cell was in view. Nothing seen to move where the
/// map looked for long is knowledge; where it never looked, it is none.
///
/// Memory for kMostActiveCells cells with motion is taken at construction; motion in further ones is counted
/// as lost.
class ActivityMap {
 public:
  static constexpr int kSpeeds = 30, kDirections = 36;
  static constexpr std::size_t kBins = kSpeeds * kDirections;
  static constexpr std::size_t kMostActiveCells = 4096;

  explicit ActivityMap(const ActivityMapParams& params);

  /// One frame of one object at p_G with velocity v_G [/frame]. Outside of the map: nothing.
  void add(const Eigen::Vector2d& p_G, const Eigen::Vector2d& v_G);

  /// One frame showed the ground within this convex polygon, whichever way round: the exposure of each cell
  /// whose middle lies in it grows. A polygon that is not finite shows nothing.
  void look(std::span<const Eigen::Vector2d> view_G);

  /// Adds all of `other`, whose frame O lies in this map's G at X_GO: p_G = R(angle) p_O + t. Cells must be
  /// of one size.
  void merge(const ActivityMap& other, double angle_rad, const Eigen::Vector2d& t_G);

  struct ActiveCell {
    std::int32_t column = 0, row = 0;
    std::uint32_t total = 0;
  };
  std::span<const ActiveCell> active() const { return active_; }
  /// Counts of an active cell, [speed][direction]; direction 0 begins at +x, growing towards +y.
  std::span<const std::uint32_t, kBins> counts(std::size_t active) const {
    return std::span<const std::uint32_t, kBins>(counts_.data() + active * kBins, kBins);
  }
  /// Index into active(), or -1.
  int find(int column, int row) const;
  /// Frames in which the cell was in view; 0 outside of the map.
  std::uint32_t exposure(int column, int row) const {
    return contains(column, row) ? exposure_[index_of(column, row)] : 0;
  }
  bool contains(int column, int row) const {
    return column >= 0 && row >= 0 && column < cells() && row < cells();
  }
  /// Of any point of G; may lie outside of the map.
  void cell_of(const Eigen::Vector2d& p_G, int& column, int& row) const;
  Eigen::Vector2d middle_of(int column, int row) const;

  double cell() const { return params_.cell; }
  int cells() const { return params_.cells; }
  double speed_per_bin() const { return params_.max_speed / (kSpeeds - 1); }
  static double direction_of_bin(int bin) { return (bin + 0.5) * 2.0 * M_PI / kDirections; }
  std::uint64_t total() const { return total_; }
  std::uint64_t lost() const { return lost_; }
  const ActivityMapParams& params() const { return params_; }

  /// For the decoder: so many more in one bin. False where there is no room, or no such cell or bin.
  bool add_count(int column, int row, std::size_t bin, std::uint32_t count);
  /// Of every cell, row by row.
  std::span<const std::uint32_t> exposures() const { return exposure_; }
  std::span<std::uint32_t> exposures() { return exposure_; }

 private:
  std::size_t index_of(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells()) +
           static_cast<std::size_t>(column);
  }

  ActivityMapParams params_;
  std::vector<std::int16_t> slot_;  ///< of each cell; -1: nothing has moved there
  std::vector<std::uint32_t> exposure_;
  std::vector<ActiveCell> active_;
  std::vector<std::uint32_t> counts_;
  std::uint64_t total_ = 0, lost_ = 0;
};

/// Bin of a velocity, [speed][direction].
std::size_t activity_bin(const ActivityMap& map, const Eigen::Vector2d& v_G);

/// The most usual motion of a cell, as the thesis draws it.
struct ActivityMode {
  double speed = 0.0;
  double direction_rad = 0.0;
  double share = 0.0;  ///< of the cell's motion within one bin about it
};
/// Local maxima of the cell's smoothed histogram, the most usual first, up to `modes.size()`; returns how
/// many.
std::size_t find_modes(const ActivityMap& map, std::size_t active, std::span<ActivityMode> modes);

}  // namespace hindsight
