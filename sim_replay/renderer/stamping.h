// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "sim_replay/renderer/texels.h"
#include "sim_replay/world/random.h"

namespace hindsight {

enum class StampShape { blade, leaf, chip, pebble };

/// Many small things of one sort that lie about: leaves, blades of grass, chips, stones.
struct Stamps {
  StampShape shape = StampShape::leaf;
  int count = 0;
  float length_min_m = 0.0F, length_max_m = 0.0F;
  float slenderness = 2.0F;  ///< length over width
  float lift_m = 0.01F;      ///< how high they may lie
  std::vector<glm::vec3> albedos;
  float tone_spread = 0.2F;  ///< of brightness, from one to the next
};

/// A tiled piece of ground: albedo, and height [m] as fourth channel.
struct GroundPatchwork {
  Texels texels;
  float texel_m;

  int px(float m) const { return static_cast<int>(m / texel_m); }
};

/// Lays the things on the ground one by one, the higher hiding the lower.
void strew(GroundPatchwork& ground, const Stamps& stamps, Random& random);

/// Albedo from sRGB values 0 to 255, as picked from pictures.
glm::vec3 albedo(int red, int green, int blue);

}  // namespace hindsight
