// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What stands in a world, as one shape seen from above: all points within a radius of a segment. Trunks,
// bushes and rocks are discs (segments of no length), fences a chain of thin capsules.
#pragma once

#include <vector>

#include "sim_replay/world/world.h"

namespace hindsight {

struct Obstacle {
  WorldPoint a;  ///< ends of the segment, in W
  WorldPoint b;
  double radius_m = 0.0;
  double height_m = 0.0;  ///< of what is solid enough for a bumper or an IR beam
  TruthLabel label = TruthLabel::tree;
  bool drivable = false;
};

/// Half the thickness of a fence.
constexpr double kFenceRadius_m = 0.03;

/// All objects of the world: trees, bushes, rocks, fences, in that order.
std::vector<Obstacle> obstacles_of(const World& world);

WorldPoint nearest_on_segment(WorldPoint a, WorldPoint b, WorldPoint p);

/// From a point to the surface; negative inside.
double distance_m(const Obstacle& obstacle, WorldPoint p);

/// "tree", "bush", "fence", ...
const char* name_of(TruthLabel label);

}  // namespace hindsight
