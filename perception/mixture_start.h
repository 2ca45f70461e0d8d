// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "perception/terrain_mixture.h"

namespace hindsight {

/// K-means over the colours of one frame (thesis 5.1: "Initial clusters"): every cluster's mean, covariance
/// and number of pixels, without votes, in the order of the clusters' mean first channel. Fewer than
/// params.start_components where the frame has fewer colours; none for an empty image. A large frame is
/// sampled on a regular grid of about `kStartSamples` pixels. The seed alone decides the start (k-means++).
std::vector<MixtureComponent> start_components(std::span<const std::uint8_t> bgr, int width_px, int height_px,
                                               const MixtureParams& params);
constexpr int kStartSamples = 8000;

}  // namespace hindsight
