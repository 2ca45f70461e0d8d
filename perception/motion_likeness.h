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

/// In so many, two ends of one vehicle and two that follow one another can be told apart.
constexpr int kFramesToTellApart = 8;

/// [px/frame] By so much mean velocities of two ends differ at most, over many frames.
inline float mean_tolerance_px(Point2f mean_v_px) {
  return 0.1F + 0.05F * std::hypot(mean_v_px.x_px, mean_v_px.y_px);
}

/// As mean velocities of two ends of one thing are, over many frames.
inline bool alike_on_average(Point2f mean_a, Point2f mean_b) {
  return distance_px(mean_a, mean_b) < mean_tolerance_px(mean_a);
}

/// As those of front and rear of a thing that turns: the same speed (root mean square), though not the same
/// way. `b_from_a_px` lies along the way they go, as what goes beside it is something else.
inline bool turn_together(Point2f mean_a, Point2f mean_b, float speed_a_px, float speed_b_px,
                          Point2f b_from_a_px) {
  constexpr float kAhead = 0.7F;  // cosine
  const float ahead = mean_a.x_px * b_from_a_px.x_px + mean_a.y_px * b_from_a_px.y_px;
  return roughly_alike(mean_a, mean_b) &&
         std::abs(ahead) >
             kAhead * std::hypot(mean_a.x_px, mean_a.y_px) * std::hypot(b_from_a_px.x_px, b_from_a_px.y_px) &&
         std::abs(speed_b_px - speed_a_px) < mean_tolerance_px(mean_a);
}

}  // namespace hindsight
