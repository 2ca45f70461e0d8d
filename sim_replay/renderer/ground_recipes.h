// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "sim_replay/renderer/stamping.h"
#include "sim_replay/world/world.h"

namespace hindsight {

/// What a kind of ground is made of.
struct GroundRecipe {
  glm::vec3 dark, bright;     ///< albedo of the bare earth in hollows and on crests
  float roughness_m = 0.01F;  ///< height of its lumps
  float grain = 0.2F;         ///< how much single grains differ
  std::vector<Stamps> stamps;
};

GroundRecipe ground_recipe(Ground ground);

}  // namespace hindsight
