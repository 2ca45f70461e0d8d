// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// How a road and what lies beside it are coloured, learned from what is known of both: the definition region,
// now and traced back, is road; what lies beside the road found so far, and above the horizon, is not.
#pragma once

#include <span>

#include "perception/definition_trace.h"
#include "perception/road_colors.h"
#include "perception/road_input.h"
#include "perception/road_params.h"
#include "perception/road_search.h"

namespace hindsight {

/// A row that fits worse than this (FoundRoad::fit) neither corrects the road's line nor teaches colours.
constexpr float kRoadFits = 0.3F;
/// Widest half width per row below the horizon (half the road's width over the camera's height).
constexpr float kWidestRoadSlope = 3.2F;

/// A row of a stored picture at which the road is looked for, and the pixel rows [top, bottom) around it
/// whose mean it is.
struct SearchRow {
  float row = 0.0F;
  int top = 0;
  int bottom = 0;
};

/// No allocation after construction. Rows, columns and horizons are those of stored pictures.
class RoadColorLearner {
 public:
  /// FatalError(kExitConfiguration) where the definition region does not lie in the picture.
  RoadColorLearner(const RoadParams& params, const RoadPicture& picture, int history_depth);

  void clear() { colors_.clear(); }
  /// What was learned fades with time.
  void fade(double dt_s);
  /// The strip in front of the vehicle; `trace`: also how it looked from afar.
  void learn_definition(const RoadInput& input, const ColorView& picture, float horizon, bool trace);
  /// `found`: of the first rows.
  void learn_beside(const ColorView& picture, std::span<const SearchRow> rows,
                    std::span<const FoundRoad> found);
  void learn_above(const ColorView& picture, float horizon);
  /// Where no road is known, the sides of the picture below the horizon: some road among it does little harm,
  /// as what is on the road as often as there comes out as likelier road.
  void learn_beside_anything(const ColorView& picture, std::span<const SearchRow> rows, float horizon);
  /// Makes colors() out of all that.
  void refresh() { colors_.refresh(); }

  const RoadColors& colors() const { return colors_; }

 private:
  RoadParams params_;
  RoadPicture picture_;
  int width_;  ///< of stored pictures
  int height_;
  DefinitionTrace definition_;
  RoadColors colors_;
};

}  // namespace hindsight
