// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "sim_replay/world/course.h"
#include "sim_replay/world/lane.h"
#include "sim_replay/world/obstacle.h"
#include "sim_replay/world/random.h"

namespace hindsight {

/// Finds places for objects: each in the strip along the lane, away from start, goal and what stands already.
class Strewing {
 public:
  Strewing(const Course& course, const Lane& lane) : course_(course), lane_(lane) {}

  /// Stands at a place that was not drawn; others keep away from it.
  void add(const Obstacle& obstacle) { standing_.push_back(obstacle); }

  /// How many of such objects the strip is to hold.
  int count(const StrewnParams& params) const;
  /// A place for a disc; later ones keep away from it. FatalError that names course and section where none is
  /// found in many drawings.
  WorldPoint place(const StrewnParams& params, double radius_m, const char* section, Random& random);

 private:
  bool has_room(WorldPoint p, double radius_m, const StrewnParams& params) const;

  const Course& course_;
  const Lane& lane_;
  std::vector<Obstacle> standing_;
};

}  // namespace hindsight
