// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "sim_replay/renderer/texels.h"

namespace hindsight {

/// Layers of the textures of what stands upright.
enum ObjectLayer : std::uint16_t {
  furrowed_bark,
  grey_bark,
  scaly_bark,
  rock_face,
  plastic,
  green_leaves,
  yellow_leaves,
  dry_leaves,
  object_layers
};
constexpr int kBarkLayers = 3;

/// Bark repeats each time round the trunk and every two rounds up. Leaves: fourth channel is where there is
/// one.
std::vector<Texels> object_textures(std::uint64_t seed);

}  // namespace hindsight
