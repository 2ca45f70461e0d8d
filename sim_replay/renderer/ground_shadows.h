// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <glm/glm.hpp>

#include "sim_replay/renderer/ground_mask.h"

namespace hindsight {

/// Texels from and to, inside the mask.
struct MaskArea {
  int x0, y0, x1, y1;
};
MaskArea area_around(const GroundMask& mask, WorldPoint a, WorldPoint b, double reach_m);
glm::vec2 place_of(const GroundMask& mask, int x, int y);

/// Shadows of all that stands, and the darker ground beneath and at the foot of it. Light is a directed sun
/// with the penumbra of its width; the ground is taken as level around each object.
void cast_shadows(GroundMask& mask, const World& world, glm::vec3 to_sun);

}  // namespace hindsight
