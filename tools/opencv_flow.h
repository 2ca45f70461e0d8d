// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <span>
#include <vector>

#include "perception/flow_vector.h"
#include "perception/optical_flow_params.h"

namespace hindsight::tools {

/// What perception/optical_flow.h does, by OpenCV's functions: GaussianBlur, goodFeaturesToTrack and
/// calcOpticalFlowPyrLK with the same kernel, quality, number, spacing, window, levels
/// and iterations (without quota and check).
/// The yardstick for speed and quality.
class OpencvFlow {
 public:
  explicit OpencvFlow(const OpticalFlowParams& params) : params_(params) {}

  std::span<const FlowVector> update(const cv::Mat& bgr);

  /// The same from a grey image: the part that is timed.
  std::span<const FlowVector> update_grey(const cv::Mat& grey);

 private:
  OpticalFlowParams params_;
  cv::Mat grey_, last_grey_, smooth_;
  std::vector<cv::Point2f> corners_, matches_;
  std::vector<unsigned char> found_;
  std::vector<float> residuals_;
  std::vector<FlowVector> flow_;
};

}  // namespace hindsight::tools
