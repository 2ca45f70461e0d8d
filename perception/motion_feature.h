// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cmath>

#include "perception/flow_vector.h"

namespace hindsight {

/// A feature that seems to move over the ground.
struct MovingFeature {
  Point2f at_px;
  Point2f v_px;           ///< over the ground, in the newest image's pixels a frame
  float probability = 0;  ///< p(c = 1)
};

inline float distance_px(Point2f a, Point2f b) { return std::hypot(a.x_px - b.x_px, a.y_px - b.y_px); }

}  // namespace hindsight
