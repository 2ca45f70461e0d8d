// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "sim_replay/renderer/texels.h"
#include "sim_replay/world/world.h"

namespace hindsight {

/// Side of the tiled piece of ground that a texture shows.
constexpr float kGroundTile_m = 2.0F;

/// Albedo, darkened in its hollows, and as fourth channel half the sunlight that falls there against level
/// ground: slopes and shadows of grains, blades and leaves under a sun that does not move. x east, y north.
Texels ground_texture(Ground ground, glm::vec3 to_sun, std::uint64_t seed);

/// How a kind of ground throws light back beside its albedo.
struct GroundGloss {
  float sheen = 0.0F;     ///< towards the sun and at grazing angles
  float exponent = 4.0F;  ///< how narrow
  float wet = 0.0F;       ///< how much it mirrors the sky
};
GroundGloss ground_gloss(Ground ground);

/// Factors to its albedo where it is driest and where it is most moist.
struct GroundVariety {
  glm::vec3 dry{1.2F};
  glm::vec3 moist{0.75F};
};
GroundVariety ground_variety(Ground ground);

}  // namespace hindsight
