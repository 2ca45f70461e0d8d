// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <opencv2/core.hpp>
#include <span>

#include "perception/motion_tracker.h"

namespace hindsight::tools {

/// The objects' numbers, sizes and velocities (over 10 frames), and the features that move, drawn into a
/// picture. Dashed colour for one that is not seen in this frame.
void draw_tracks(cv::Mat& picture, std::span<const Track> tracks, std::span<const MovingFeature> features);

}  // namespace hindsight::tools
