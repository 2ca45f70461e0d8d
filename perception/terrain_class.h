// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace hindsight {

/// Class label of a pixel, a mixture component or a grid cell (thesis 5.1). `unknown` is not a class of the
/// mixture: it says that nothing known comes near.
enum class TerrainClass : std::uint8_t { good = 0, bad = 1, lethal = 2, unknown = 3 };
constexpr int kLabelCount = 3;

}  // namespace hindsight
