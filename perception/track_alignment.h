// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "perception/pose.h"

namespace hindsight {

/// Weighted least-squares fit of the planar rigid motion that carries one track of points onto another (the
/// two-dimensional case of Horn 1987, Umeyama 1991), from running sums. It is how a heading comes out of GPS:
/// the track that the wheels drove in W against the track of the fixes in E. Plain data, no allocation.
class TrackAlignment {
 public:
  /// The same place in both frames; `sigma_m` > 0 is one standard deviation of p_EP_m along each axis.
  void add(const Point2& p_WP_m, const Point2& p_EP_m, double sigma_m);
  void clear() { *this = {}; }

  int count() const { return count_; }
  /// p_WP = X_WE * p_EP. Needs count() >= 2.
  Pose2 X_WE() const;
  /// One standard deviation of the heading in X_WE(); infinite while all points coincide.
  double heading_sigma_rad() const;
  /// One standard deviation of the fitted track's middle, along each axis.
  double centre_sigma_m() const;
  /// Middle of the track, in W.
  Point2 centre_W_m() const;
  /// Weighted squared residuals for each degree of freedom: about 1 where the two tracks have the same shape.
  /// 0 while count() < 2.
  double reduced_chi_square() const;

 private:
  // Weighted mean and centred second moments, updated point by point (Welford), so that nothing cancels.
  double weight_ = 0.0;
  int count_ = 0;
  Point2 mean_W_, mean_E_;
  double spread_W_ = 0.0;  ///< sum of w |p_W - mean_W|^2
  double spread_E_ = 0.0;
  double dot_ = 0.0;    ///< sum of w (p_E - mean_E) . (p_W - mean_W)
  double cross_ = 0.0;  ///< sum of w (p_E - mean_E) x (p_W - mean_W)
};

}  // namespace hindsight
