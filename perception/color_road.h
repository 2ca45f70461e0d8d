// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The default road follower. What is known to be road, traced back, says how the road is coloured near and
// far; what lies beside the road found so far says how that is coloured. The road is the path up the picture,
// as wide as perspective wants, that has most of the one inside and most of the other beside; a filter
// carries it over time.
#pragma once

#include <vector>

#include "perception/far_motion.h"
#include "perception/road_color_learner.h"
#include "perception/road_estimate.h"
#include "perception/road_input.h"
#include "perception/road_line_filter.h"
#include "perception/road_params.h"
#include "perception/road_profile.h"
#include "perception/road_rise.h"
#include "perception/road_search.h"
#include "perception/road_shape.h"

namespace hindsight {

/// No allocation after construction. Deterministic. Not thread-safe. Rows and columns inside are those of
/// stored pictures.
class ColorRoad {
 public:
  /// FatalError(kExitConfiguration) where the definition region does not lie in the picture.
  ColorRoad(const RoadParams& params, const RoadPicture& picture, int history_depth);

  /// Forgets the road: the stream of frames was interrupted.
  void reset();
  /// To be called for each frame.
  void update(const RoadInput& input, RoadEstimate& estimate);

 private:
  void learn(const RoadInput& input, const ColorView& picture);
  void lay_rows(const RoadShape& shape);
  void fill_profile(const ColorView& picture);
  void follow(const RoadInput& input, const ColorView& picture);
  void acquire(const ColorView& picture);
  std::span<const FoundRoad> search(const RoadShape& shape, bool acquiring);
  void refine(std::span<const FoundRoad> found);
  void adapt_shape(std::span<const FoundRoad> found, float horizon_gain);
  void correct(std::span<const FoundRoad> found);
  float judge(std::span<const FoundRoad> found);
  void draw_line();
  void look_up(const ColorView& picture);
  void tell(RoadEstimate& estimate) const;

  RoadParams params_;
  RoadPicture picture_;
  int stored_width_;
  int stored_height_;
  FarMotionFinder far_motion_;
  RoadColorLearner learner_;
  RoadProfile profile_;
  RoadSearch search_;
  RoadLineFilter filter_;
  RoadShape shape_;
  float swing_ = 0.0F;  ///< of the horizon, beside where it lies for long
  std::vector<SearchRow> rows_;
  std::vector<ExpectedRoad> expected_;
  std::vector<FoundRoad> found_;
  bool following_ = false;
  float confidence_ = 0.0F;
  int visible_rows_ = 0;
  RoadRise rise_;
  std::vector<FoundRoad> line_;  ///< the visible rows on flat ground, as the filter has them
  std::size_t flat_rows_ = 0;    ///< of it that are told where the road beyond rises
  bool risen_ = false;
  int frames_ = 0;
};

}  // namespace hindsight
