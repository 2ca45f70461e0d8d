// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <opencv2/core.hpp>

#include "perception/road_follower.h"

namespace hindsight::tools {

/// Onto the frame that the follower saw last: the road's outline and middle. With the thesis' method also the
/// matches of its strips along their rows (thesis figure 4.4: the lighter, the better, and the best as a dark
/// dot).
void draw_road(cv::Mat& picture, const RoadFollower& follower);

}  // namespace hindsight::tools
