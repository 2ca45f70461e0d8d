// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The thesis' measures of road following (4.2.2).
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <optional>

namespace hindsight::tools {

constexpr int kRoadLines = 5;

/// Of one frame.
struct RoadFrameScore {
  double pixel_coverage = 0.0;                     ///< (road called road - other called road) / road
  std::array<double, kRoadLines> line_coverage{};  ///< the same on rows from near (0) to far
  bool failed = false;                             ///< not one pixel of the road was called road
};

/// truth: RoadTruthPixel; called: not 0 where road was said to be; both of one size. Lines lie evenly between
/// the truth's uppermost and lowermost row, at the middles of five bands. Empty where the truth has no road.
std::optional<RoadFrameScore> score_road(const cv::Mat& truth, const cv::Mat& called);

/// Over a sequence.
struct RoadScore {
  int frames = 0;  ///< scored
  int failures = 0;
  double pixel_coverage = 0.0;
  std::array<double, kRoadLines> line_coverage{};

  void add(const RoadFrameScore& frame);  ///< the coverages become means
  /// Frames of video for each failure; without one, all of them: it is at least so many.
  double mttf_frames(double video_frames) const {
    return failures > 0 ? video_frames / failures : video_frames;
  }
};

}  // namespace hindsight::tools
