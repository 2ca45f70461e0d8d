// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/opencv_flow.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

namespace hindsight::tools {
namespace {

// The default, 1e-4, loses half of the corners of smooth scenes with a window of 3 x 3 pixels.
constexpr double kMinEigenvalue = 1e-5;

}  // namespace

std::span<const FlowVector> OpencvFlow::update(const cv::Mat& bgr) {
  cv::cvtColor(bgr, grey_, cv::COLOR_BGR2GRAY);
  return update_grey(grey_);
}

std::span<const FlowVector> OpencvFlow::update_grey(const cv::Mat& grey) {
  const CornerParams& corner = params_.corners;
  const TrackerParams& tracker = params_.tracker;
  flow_.clear();
  cv::GaussianBlur(grey, smooth_, {corner.smoothing_kernel_px, corner.smoothing_kernel_px},
                   corner.smoothing_sigma_px);
  cv::goodFeaturesToTrack(smooth_, corners_, corner.max_features, corner.quality, corner.min_spacing_px);
  if (!last_grey_.empty() && !corners_.empty()) {
    cv::calcOpticalFlowPyrLK(grey, last_grey_, corners_, matches_, found_, residuals_,
                             {tracker.window_px, tracker.window_px}, tracker.pyramid_levels - 1,
                             {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, tracker.max_iterations, tracker.stop_step_px},
                             0, kMinEigenvalue);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const cv::Point2f step = matches_[i] - corners_[i];
      if (found_[i] != 0) flow_.push_back({corners_[i].x, corners_[i].y, step.x, step.y});
    }
  }
  grey.copyTo(last_grey_);
  return flow_;
}

}  // namespace hindsight::tools
