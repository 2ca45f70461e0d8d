// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/video_tracker.h"

#include <Eigen/Geometry>

namespace hindsight::tools {
namespace {

Eigen::Vector2d mapped(const Eigen::Matrix3d& H, const Eigen::Vector2d& p) {
  return (H * p.homogeneous()).hnormalized();
}

}  // namespace

VideoTracker::VideoTracker(const MotionParams& params, cv::Size size)
    : tracker_(params, size.width, size.height,
               static_cast<std::size_t>(OpticalFlowParams{}.corners.max_features)) {}

const MotionReport& VideoTracker::step(std::span<const FlowVector> flow, const Eigen::Matrix3d& H_G_image) {
  if (prior_) prior_->look(H_G_image);
  return tracker_.update(flow, prior_.get());
}

std::array<Eigen::Vector2d, 4> view_of(cv::Size size, const Eigen::Matrix3d& H_G_image) {
  const double w = size.width, h = size.height;
  return {mapped(H_G_image, {0.0, 0.0}), mapped(H_G_image, {w, 0.0}), mapped(H_G_image, {w, h}),
          mapped(H_G_image, {0.0, h})};
}

}  // namespace hindsight::tools
