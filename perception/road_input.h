// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>

#include "perception/appearance_history.h"
#include "perception/flow_history.h"
#include "perception/flow_vector.h"

namespace hindsight {

/// What a road follower needs of the newest frame: histories that hold it already.
struct RoadInput {
  std::span<const FlowVector> flow;  ///< from the newest frame to the one before
  const FlowHistory& history;
  const AppearanceHistory& appearance;
  double dt_s = 0.1;  ///< since the frame before
};

/// The picture's size, how much smaller stored pictures are, and the horizon's row in the middle of the
/// picture where the camera's mounting tells it (NaN: it does not).
struct RoadPicture {
  int width_px = 0;
  int height_px = 0;
  int shrink = 1;
  double horizon_row_px = 0.0;

  /// Row or column of the full picture that one of a stored picture shows the middle of.
  float full_px(float stored_px) const {
    const auto factor = static_cast<float>(shrink);
    return stored_px * factor + 0.5F * (factor - 1.0F);
  }
};

}  // namespace hindsight
