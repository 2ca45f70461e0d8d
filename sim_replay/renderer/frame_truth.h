// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "sim_replay/renderer/lens.h"
#include "sim_replay/renderer/renderer.h"

namespace hindsight {

/// The wide picture as drawn: objects with the numbers of scene.h, depth as near / depth.
struct WideTruth {
  std::vector<std::uint16_t> objects;
  std::vector<float> depths;
};

/// Resamples the truth for each pixel of the camera: labels and objects of the nearest wide pixel, depth
/// between pixels of the same surface.
void fill_truth(const World& world, const Lens& lens, const WideTruth& wide, RenderedFrame& frame);

}  // namespace hindsight
