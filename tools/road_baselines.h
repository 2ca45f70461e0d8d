// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What the thesis compares its road follower with (4.2.2): methods that look at one frame only. Each takes an
// 8-bit BGR frame and the definition region, and returns a mask, not 0 where it says road.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

namespace hindsight::tools {

/// Markov random field with Metropolis sampling (Kato): two classes, colour Gaussians with full covariances,
/// trained on the definition region and on a square of half its width at the picture's left, both fixed. On a
/// picture of about 320 columns, which smooths as much as the neighbours do.
cv::Mat mrf_road(const cv::Mat& bgr, const cv::Rect& region, std::uint64_t seed);

/// Within 10 in hue, 20 in saturation and value of the region's mean (OpenCV's units).
cv::Mat hsv_road(const cv::Mat& bgr, const cv::Rect& region);

/// 20 x 20 px windows whose squared difference from the one in the middle of the region is no larger than
/// that of nine in ten windows inside the region.
cv::Mat texture_road(const cv::Mat& bgr, const cv::Rect& region);

}  // namespace hindsight::tools
