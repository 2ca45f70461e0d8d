// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Two activity maps of one place, brought together by motion alone (thesis 3.2.2).
#pragma once

#include <Eigen/Core>

#include "perception/activity_map.h"

namespace hindsight {

/// Where map B lies in the frame of map A: p_A = R(angle) p_B + t.
struct ActivityAlignment {
  double angle_rad = 0.0;
  Eigen::Vector2d t = Eigen::Vector2d::Zero();
  double likeness =
      0.0;  ///< normalised correlation of what moves where and which way; 1: the same, 0: nothing alike
};

/// Brute force over rotations and translations for the smallest sum of squared differences, coarse to fine:
/// cells of four, two and one, the best few of each level going on to the next. Instead of one intensity for
/// a cell's main mode, a cell is how much moves in it (logarithm of its count) and the first and second
/// Fourier coefficients of its directions, which a rotation turns by once and twice its angle: cells used in
/// both directions keep both. Compared is what both maps looked at (ActivityMap::exposure; a map without
/// exposures looked everywhere), by the largest normalised product, which is there the smallest difference.
ActivityAlignment register_activity(const ActivityMap& a, const ActivityMap& b);

/// Maps of ideal places, about the origin, arms as long as `reach` (unit of the cell), traffic on the right.
/// `lane`: distance of a lane's middle from the road's.
ActivityMap crossroads_template(const ActivityMapParams& params, double reach, double lane, double speed);
ActivityMap roundabout_template(const ActivityMapParams& params, double reach, double lane, double speed,
                                double ring);

}  // namespace hindsight
