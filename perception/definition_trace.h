// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The strip ahead of the vehicle that is known to be road, and where it was in earlier frames (thesis 4.1).
#pragma once

#include <span>
#include <vector>

#include "perception/flow_history.h"
#include "perception/road_input.h"
#include "perception/road_params.h"

namespace hindsight {

/// A strip of a picture: columns [left, right), rows [top, top + height); pixels of the full picture.
struct RoadStrip {
  float left_px = 0.0F;
  float right_px = 0.0F;
  float top_px = 0.0F;
  int frames_back = 0;

  float width_px() const { return right_px - left_px; }
  float middle_px() const { return 0.5F * (left_px + right_px); }
};

/// The definition region. FatalError(kExitConfiguration) where it does not lie in the picture.
RoadStrip definition_region(const RoadParams& params, const RoadPicture& picture);

/// No allocation after construction.
class DefinitionTrace {
 public:
  DefinitionTrace(const RoadParams& params, const RoadPicture& picture, int history_depth);

  /// Where the definition region of the newest frame was: up to `count` strips, from near to far, at times
  /// such that they are spaced evenly down the picture, the last as far back as can be traced.
  std::span<const RoadStrip> trace(const FlowHistory& history, int count);

  const RoadStrip& region() const { return region_; }

 private:
  RoadStrip region_;
  float height_px_;
  float picture_width_px_;
  std::vector<RoadStrip> all_;
  std::vector<RoadStrip> chosen_;
};

}  // namespace hindsight
