// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Where the road goes ahead of a vehicle that is on it (thesis 4).
#pragma once

#include <variant>

#include "perception/color_road.h"
#include "perception/road_estimate.h"
#include "perception/road_input.h"
#include "perception/road_params.h"
#include "perception/template_road.h"

namespace hindsight {

/// One method, chosen by RoadParams::method, and the conditions under which it may speak. No allocation after
/// construction. Deterministic. Not thread-safe.
class RoadFollower {
 public:
  /// history_depth: of the flow history. FatalError(kExitConfiguration) where the parameters do not fit the
  /// picture.
  RoadFollower(const RoadParams& params, const RoadPicture& picture, int history_depth);

  /// The stream of frames was interrupted.
  void reset();
  /// To be called for each frame once the histories hold it. Valid until the next call.
  const RoadEstimate& update(const RoadInput& input);

  const RoadEstimate& estimate() const { return estimate_; }
  /// The thesis' method, for pictures; null with the other.
  const TemplateRoad* templates() const { return std::get_if<TemplateRoad>(&method_); }

 private:
  RoadParams params_;
  std::variant<ColorRoad, TemplateRoad> method_;
  double seen_s_ = 0.0;
  RoadEstimate estimate_;
};

}  // namespace hindsight
