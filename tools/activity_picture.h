// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "perception/activity_map.h"

namespace hindsight::tools {

/// As figure 3.5: in each cell the two most usual motions, as long as half a second of them, as thick as they
/// are frequent. `H_picture_G` takes the map's frame to the picture.
void draw_activity(cv::Mat& picture, const ActivityMap& map, const Eigen::Matrix3d& H_picture_G);

}  // namespace hindsight::tools
