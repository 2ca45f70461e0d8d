// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <glm/glm.hpp>

#include "sim_replay/renderer/texels.h"
#include "sim_replay/world/world.h"

namespace hindsight {

/// What differs from place to place of the ground where things stand, seen from above.
struct GroundMask {
  glm::vec2 corner_m;  ///< south-west, in W
  glm::vec2 size_m;
  Texels light;  ///< sunlight left by all shadows; sky left; sunlight left by crowns of trees alone;
                 ///< brightness, 0.5: mean
  Texels kinds;  ///< share of trails; share of patches; how dry, 0.5: mean; unused
  Ground trail = Ground::soil;
  Ground patch = Ground::mud;
};

GroundMask ground_mask(const World& world, glm::vec3 to_sun);

}  // namespace hindsight
