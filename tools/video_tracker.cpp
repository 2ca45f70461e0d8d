// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/video_tracker.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tools/report_style.h"

namespace hindsight::tools {
namespace {

constexpr double kArrowFrames = 5.0;
constexpr double kLeastShare = 0.15;

Eigen::Vector2d mapped(const Eigen::Matrix3d& H, const Eigen::Vector2d& p) {
  return (H * p.homogeneous()).hnormalized();
}

cv::Point pixel(const Eigen::Vector2d& p) { return {cvRound(p.x()), cvRound(p.y())}; }

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

void draw_activity(cv::Mat& picture, const ActivityMap& map, const Eigen::Matrix3d& H_image_G) {
  std::uint32_t most = 1;
  for (const auto& cell : map.active()) most = std::max(most, cell.total);
  for (std::size_t i = 0; i < map.active().size(); ++i) {
    const auto& cell = map.active()[i];
    std::array<ActivityMode, 2> modes{};
    const std::size_t count = find_modes(map, i, modes);
    const Eigen::Vector2d middle = map.middle_of(cell.column, cell.row);
    for (std::size_t k = 0; k < count; ++k) {
      if (modes[k].share < kLeastShare) continue;
      const Eigen::Vector2d way(std::cos(modes[k].direction_rad), std::sin(modes[k].direction_rad));
      const double often = modes[k].share * cell.total / most;
      cv::arrowedLine(picture, pixel(mapped(H_image_G, middle)),
                      pixel(mapped(H_image_G, middle + kArrowFrames * modes[k].speed * way)),
                      (k == 0 ? kLeft : kRight).bgr(), 1 + static_cast<int>(3.0 * std::sqrt(often)),
                      cv::LINE_AA, 0, 0.3);
    }
  }
}

}  // namespace hindsight::tools
