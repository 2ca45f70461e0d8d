// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "sim_replay/world/world.h"

namespace hindsight {

/// A flat card with a twig's leaves: middle and half axes, in W.
struct LeafCard {
  glm::vec3 middle, half_u, half_v;
};

/// A tapered piece of trunk, branch or stem.
struct Limb {
  glm::vec3 from, to;
  float radius_from_m, radius_to_m;
};

/// What a tree or bush consists of, in W. Its leaves fill an upright ellipsoid, denser in clumps.
struct PlantShape {
  std::vector<Limb> limbs;  ///< of a tree: the trunk's pieces first, from the ground up
  int trunk_limbs = 0;
  std::vector<LeafCard> cards;  ///< in random order: any first part of them is a thinner version
  glm::vec3 crown_middle, crown_radii;
  std::uint16_t bark = 0, leaves = 0;  ///< ObjectLayer
  glm::vec3 leaf_tint{1.0F}, bark_tint{1.0F};

  /// Share of sunlight that comes through its own leaves to a point.
  float light_through(glm::vec3 p, glm::vec3 to_light) const;
};

PlantShape shape_of(const Tree& tree, const Terrain& terrain);
PlantShape shape_of(const Bush& bush, const Terrain& terrain);

}  // namespace hindsight
