// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The thesis' road follower (4.1): strips of how the road ahead looked from afar are matched along rows, and
// dynamic programming makes a path of the matches.
#pragma once

#include <cstdint>
#include <vector>

#include "perception/definition_trace.h"
#include "perception/far_motion.h"
#include "perception/horizon_line.h"
#include "perception/road_estimate.h"
#include "perception/road_input.h"
#include "perception/road_params.h"
#include "perception/template_row.h"

namespace hindsight {

/// No allocation after construction. Deterministic. Not thread-safe.
class TemplateRoad {
 public:
  /// FatalError(kExitConfiguration) as DefinitionTrace and TemplateRow.
  TemplateRoad(const RoadParams& params, const RoadPicture& picture, int history_depth);

  void reset();
  /// To be called for each frame.
  void update(const RoadInput& input, RoadEstimate& estimate);

  /// Of the newest search, for pictures: one response along the row of each template, near to far; left
  /// edges.
  struct SearchLine {
    float row_px = 0.0F;
    float width_px = 0.0F;
    std::span<const float> response;
  };
  std::span<const SearchLine> lines() const { return lines_; }
  int shrink() const { return picture_.shrink; }

 private:
  struct Template {
    TemplateRow row;
    RoadStrip strip;
    float horizon_px = 0.0F;  ///< in the frame that it is from
    bool taken = false;
  };

  int widest_template() const;
  void find_horizon(const RoadInput& input);
  void refresh(const RoadInput& input);
  void search(const RoadInput& input);
  void find_path();
  float horizon_px(int frames_back) const;
  float cost_at(const SearchLine& line, int column) const;

  RoadParams params_;
  RoadPicture picture_;
  TemplateMatch match_;
  int stored_width_;
  int stored_height_;
  DefinitionTrace definition_;
  HorizonFinder horizon_finder_;
  FarMotionFinder far_motion_;
  std::vector<float> horizons_px_;  ///< ring over frames; NaN: none in view
  int newest_ = 0;
  int frames_ = 0;
  std::vector<Template> templates_;
  std::vector<float> responses_;
  std::vector<SearchLine> lines_;
  std::vector<float> cost_, cost_before_;
  std::vector<std::uint16_t> link_;
  std::vector<int> path_;  ///< column of the road's middle on each line
};

}  // namespace hindsight
