// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Where many features move alike: candidates for objects (thesis 3.1.3).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "perception/motion_feature.h"

namespace hindsight {

/// A peak of motion and what is linked to it.
struct MotionCluster {
  Point2f at_px;      ///< the peak
  Point2f v_px;       ///< mean velocity at the peak [px/frame]
  float mass = 0.0F;  ///< sum of p(c = 1) of all that is linked
  int features = 0;
};

/// Tiled mean-shift: a search for a peak starts in every tile of kernel size that holds motion. Peaks linked
/// by features that move alike are one object: a vehicle may be larger than the kernel. No allocation once
/// the vectors have grown. Not thread-safe.
class MotionClusters {
 public:
  MotionClusters(double kernel_width_px, double kernel_height_px, std::size_t max_features);

  /// All clusters; cluster_of() tells which one a feature belongs to.
  std::span<const MotionCluster> find(std::span<const MovingFeature> features);
  int cluster_of(std::size_t feature) const { return cluster_of_[feature]; }

 private:
  void link(std::span<const MovingFeature> features);
  std::size_t root(std::size_t i);
  void start_tiles(std::span<const MovingFeature> features);
  MotionCluster climb(MotionCluster start, std::span<const MovingFeature> features) const;

  float half_width_px_, half_height_px_, reach_px_;
  std::vector<std::size_t> order_;   ///< features by x
  std::vector<std::size_t> parent_;  ///< union-find over features
  std::vector<int> cluster_of_;
  std::vector<MotionCluster> starts_, clusters_;
  struct TileKey {
    std::size_t group;
    int column, row;
    std::size_t feature;
  };
  std::vector<TileKey> tiles_;
};

/// How far the features of one thing may lie apart: half a kernel, or what it moves in four frames. What
/// moves fast over the picture is large in it: people are about three frames' way wide, cyclists five long
/// and cars eight, whatever the distance.
float link_reach_px(float half_kernel_px, Point2f v_px);

/// Do these two velocities belong to one rigid thing? [px/frame]
bool move_alike(Point2f a, Point2f b);

}  // namespace hindsight
