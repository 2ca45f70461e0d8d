// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What things look like from the air, as small pictures.
#pragma once

#include <opencv2/core.hpp>

namespace hindsight::tools {

/// Noise of several scales about a colour, BGR; octaves from finest_px to coarsest_px.
cv::Mat mottled(cv::Size size, const cv::Scalar& bgr, double contrast, int finest_px, int coarsest_px,
                cv::RNG& random);
/// With an alpha plane, all of it seen.
cv::Mat opaque(const cv::Mat& bgr);
/// BGRA, cut to an ellipse with a ragged edge: a crown from above.
cv::Mat round_cut(const cv::Mat& bgr, cv::RNG& random);
/// Of cars and shirts.
cv::Scalar some_color(cv::RNG& random);
/// BGRA, nose to the right.
cv::Mat car_from_above(cv::RNG& random);
/// BGRA, walking to the right; `stride`: of hands and feet [px]; `cycle`: on a bicycle.
cv::Mat person_from_above(const cv::Scalar& shirt, int stride, bool cycle);

}  // namespace hindsight::tools
