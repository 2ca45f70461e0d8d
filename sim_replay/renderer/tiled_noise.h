// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace hindsight {

/// Smooth noise, 0 to 1, of grain 1; repeats after period in both directions (a power of two).
float tiled_noise(float x, float y, int period, std::uint32_t seed);

/// Sum of octaves of halving grain and height, 0 to 1; the coarsest grain is size / period.
float tiled_fractal(float x, float y, int period, int octaves, std::uint32_t seed);

}  // namespace hindsight
