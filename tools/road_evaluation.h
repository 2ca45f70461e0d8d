// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A method of finding the road, scored on recorded frames with truth (thesis 4.2).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "daemon/robot_config.h"
#include "tools/road_frames.h"
#include "tools/road_method.h"
#include "tools/road_score.h"
#include "tools/road_truth.h"

namespace hindsight::tools {

struct RoadEvaluation {
  std::vector<RoadFrameFile> frames;
  double rate_hz = 10.0;
  std::string method = "ours";  ///< ours, thesis, mrf, hsv, texture or constant
  Configuration configuration;  ///< of the method
  double horizon_row_px = 0.0;  ///< NaN: not known
};

struct RoadEvaluationResult {
  RoadScore score;
  double mttf_frames = 0.0;
  double ms_per_frame = 0.0;  ///< beside flow and histories, which the daemon has anyway
  int off_road_frames = 0;    ///< scored frames whose definition region is not road for the most part
  int no_horizon_frames = 0;  ///< scored frames in which a road follower saw no horizon
  int silent_frames = 0;      ///< scored frames in which the method said nothing
};

/// Frames that are scored: those with truth, from the first on that has the history that a road follower
/// needs, at most one a second. FatalError(kExitBadData) where there are none.
std::vector<std::size_t> frames_to_score(const RoadEvaluation& evaluation, const RoadTruth& truth);

/// Sees each scored frame: its picture, its truth, and the method that has just called `called` road.
using RoadWatcher = std::function<void(const std::string& name, const cv::Mat& bgr, const cv::Mat& truth,
                                       const cv::Mat& called, const RoadMethod& method)>;

/// FatalError(kExitBadData) for frames of mixed size, and where the definition region is off the road in all
/// scored frames.
RoadEvaluationResult evaluate_road(const RoadEvaluation& evaluation, const RoadTruth& truth,
                                   const RoadWatcher& watch,
                                   const std::function<void(std::size_t)>& progress);

}  // namespace hindsight::tools
