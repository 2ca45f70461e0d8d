// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Whether two velocities in the picture may be those of one thing.
#pragma once

#include <algorithm>
#include <cmath>

#include "perception/motion_feature.h"

namespace hindsight {

/// A thing is at most as long as it moves in so many frames (see link_reach_px).
constexpr float kLongest_frames = 8.0F;

inline float longest_px(Point2f v_px) { return kLongest_frames * std::hypot(v_px.x_px, v_px.y_px); }

/// A slow vehicle is longer than that: its length does not change with its speed.
inline float longest_slow_px(Point2f v_px) { return 11.0F * std::hypot(v_px.x_px, v_px.y_px); }

inline bool roughly_alike(Point2f a, Point2f b) {
  const float speed = std::max(std::hypot(a.x_px, a.y_px), std::hypot(b.x_px, b.y_px));
  return distance_px(a, b) < 1.0F + 0.6F * speed;
}

/// As two ends of one thing do that does not turn.
inline bool rigidly_alike(Point2f a, Point2f b) {
  const float speed = std::max(std::hypot(a.x_px, a.y_px), std::hypot(b.x_px, b.y_px));
  return distance_px(a, b) < 0.3F + 0.15F * speed;
}

/// As mean velocities of two ends are, over many frames.
inline bool alike_on_average(Point2f mean_a, Point2f mean_b) {
  return distance_px(mean_a, mean_b) < 0.1F + 0.05F * std::hypot(mean_a.x_px, mean_a.y_px);
}

}  // namespace hindsight
