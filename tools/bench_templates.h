// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <opencv2/core.hpp>
#include <span>

namespace hindsight::tools {

/// Medians over the frames of one thread's processor time.
struct TemplateBench {
  double opencv_ms = 0.0;  ///< cv::matchTemplate TM_SQDIFF_NORMED of ten strips, each along one row
  double ours_ms = 0.0;    ///< the same with TemplateRow
  double largest_difference = 0.0;
  double over_opencv() const { return ours_ms / opencv_ms; }
};

/// Ten strips in colour, 20 px high and 100 to 300 px wide, from a frame before. Frames: CV_8UC3, continuous,
/// all of one size, at least two.
TemplateBench bench_templates(std::span<const cv::Mat> bgr_frames);

/// What the road costs beside flow and histories [ms a frame], with the default method: median, following a
/// road.
double bench_road_ms(std::span<const cv::Mat> bgr_frames);

}  // namespace hindsight::tools
