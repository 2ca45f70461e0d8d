// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// From tracks to an activity map: who teaches it (thesis 3.1.4).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "perception/activity_map.h"
#include "perception/object_tracker.h"

namespace hindsight {

/// A track teaches the map once it has got kProven_cells away from where it began, and then all of its way at
/// once, its beginning too. What never gets away, as a roof that sways, teaches nothing: else the map would
/// vouch for the tracker's own errors where they come back.
///
/// Allocates for each new track. Not thread-safe.
class ActivityLearner {
 public:
  static constexpr double kProven_cells = 4.0;

  /// One frame: its tracks, the ground that it shows, as a convex polygon in G, and where it lies in G.
  void learn(std::span<const Track> tracks, std::span<const Eigen::Vector2d> view_G,
             const Eigen::Matrix3d& H_G_image, ActivityMap& map);

 private:
  struct Motion {
    Eigen::Vector2d p_G, v_G;
  };
  struct Way {
    std::vector<Motion> pending;  ///< not yet taught
    bool proven = false;
  };
  std::map<std::int32_t, Way> ways_;  ///< by the track's number
};

}  // namespace hindsight
