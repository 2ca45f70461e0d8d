// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/activity_picture.h"

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

cv::Point pixel(const Eigen::Matrix3d& H_picture_G, const Eigen::Vector2d& p_G) {
  const Eigen::Vector2d p = (H_picture_G * p_G.homogeneous()).hnormalized();
  return {cvRound(p.x()), cvRound(p.y())};
}

}  // namespace

void draw_activity(cv::Mat& picture, const ActivityMap& map, const Eigen::Matrix3d& H_picture_G) {
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
      cv::arrowedLine(picture, pixel(H_picture_G, middle),
                      pixel(H_picture_G, middle + kArrowFrames * modes[k].speed * way),
                      (k == 0 ? kLeft : kRight).bgr(), 1 + static_cast<int>(3.0 * std::sqrt(often)),
                      cv::LINE_AA, 0, 0.3);
    }
  }
}

}  // namespace hindsight::tools
