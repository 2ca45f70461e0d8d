// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "perception/terrain_class.h"

namespace hindsight {

/// A vote for the class of the ground at a point of B. The label is good, bad or lethal.
struct GroundVote {
  float x_B_m = 0.0F;
  float y_B_m = 0.0F;
  float weight = 0.0F;
  TerrainClass label = TerrainClass::good;
};

}  // namespace hindsight
