// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <glm/glm.hpp>

#include "sim_replay/renderer/ground_mask.h"

namespace hindsight {

/// The sun, and what crowns leave of it.
struct Sunshine {
  glm::vec3 to_sun;
  const GroundMask& mask;

  /// Share of sunlight that trees let through to a point below their leaves, over ground of height ground_z:
  /// that which falls where the point's shadow falls.
  float below_crowns(glm::vec3 p, float ground_z) const;
};

}  // namespace hindsight
