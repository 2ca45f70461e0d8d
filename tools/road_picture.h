// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <opencv2/core.hpp>

namespace hindsight::tools {

/// The frame with what was called road tinted, green where it is road and red where it is not, and the truth
/// outlined. truth: RoadTruthPixel; called: not 0 where road was called.
cv::Mat draw_called_road(const cv::Mat& bgr, const cv::Mat& truth, const cv::Mat& called);

}  // namespace hindsight::tools
