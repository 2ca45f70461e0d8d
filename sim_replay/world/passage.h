// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "sim_replay/world/world.h"

namespace hindsight {

/// A rectangle of W along its axes.
struct WorldBox {
  WorldPoint least;
  WorldPoint most;
};

/// Whether a disc of diameter gap_m can go from start to goal between the rigid objects without its middle
/// leaving the box: flood fill on a grid of 0.2 m.
bool is_passable(const World& world, const WorldBox& box, double gap_m);

}  // namespace hindsight
