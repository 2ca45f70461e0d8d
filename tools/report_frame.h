// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "daemon/learner.h"
#include "daemon/robot.h"

namespace hindsight::tools {

/// The patches of the newest frame that lessons are about.
std::vector<ImageRect> touched_patches(std::span<const Lesson> lessons);

/// The frame as the robot saw it: labels as transparent colours, the horizon, flow from where points were to
/// where they are, the foot of each column's nearest obstacle, the road, and `touched` patches. `sight` must have taken
/// the frame in.
cv::Mat draw_frame(const Frame& frame, const Robot& robot, std::span<const ImageRect> touched);

/// The same pixels as an image of OpenCV, not copied; the bytes must outlive it and are not to be written to.
cv::Mat view_of(std::span<const std::uint8_t> bgr, int width_px, int height_px);

cv::Rect pixel_rect(const ImageRect& rect, double scale);

}  // namespace hindsight::tools
