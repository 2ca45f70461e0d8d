// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/sunshine.h"

#include <algorithm>

namespace hindsight {

float Sunshine::below_crowns(glm::vec3 p, float ground_z) const {
  const glm::vec2 at = glm::vec2(p) - glm::vec2(to_sun) / to_sun.z * std::max(0.0F, p.z - ground_z);
  const glm::vec2 texel = (at - mask.corner_m) / mask.size_m * glm::vec2(mask.light.width, mask.light.height);
  if (texel.x < 0.0F || texel.y < 0.0F) return 1.0F;
  const int x = static_cast<int>(texel.x), y = static_cast<int>(texel.y);
  return x < mask.light.width && y < mask.light.height ? mask.light.at(x, y).b : 1.0F;
}

}  // namespace hindsight
