// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace hindsight {

/// What the robot is for at the moment. Numbers are published and logged: append, never renumber.
enum class Mode : std::uint8_t {
  watch = 0,  ///< see and learn, never drive (a person drives, or nobody)
  drive = 1,  ///< go to the goal
  road = 2    ///< follow the road, until the goal is near if there is one
};
constexpr int kModeCount = 3;

}  // namespace hindsight
