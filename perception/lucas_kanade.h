// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Pyramidal Lucas-Kanade tracking (thesis 2.2), after Bouguet, "Pyramidal implementation of the Lucas Kanade
// feature tracker", 2000: the gradient matrix comes from the window in the image that the point is known in,
// so that it is made once a level and a step costs one resampling of the other image.
#pragma once

#include <span>

#include "perception/flow_vector.h"
#include "perception/image_pyramid.h"
#include "perception/optical_flow_params.h"

namespace hindsight {

/// The place of a point in the other image. Not found: the point or its match lies outside the image, or its
/// window is too smooth to be matched; `point_px` then has no meaning.
struct TrackedPoint {
  Point2f point_px;
  bool found = false;
};

/// Looks for each of `points_px` of the image `from` in the image `to`, beginning at `guesses_px`, which may
/// be `points_px` itself; all three spans have one length. Both pyramids have one shape.
void track_points(const TrackerParams& params, const ImagePyramid& from, const ImagePyramid& to, int levels,
                  std::span<const Point2f> points_px, std::span<const Point2f> guesses_px,
                  std::span<TrackedPoint> tracked);

}  // namespace hindsight
