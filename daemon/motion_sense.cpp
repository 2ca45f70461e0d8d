// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/motion_sense.h"

#include <cmath>
#include <limits>
#include <optional>

#include "perception/ground_plane.h"

namespace hindsight {
namespace {

/// Ground farther away is known too poorly to say how fast something moves there.
constexpr double kFarthest_m = 30.0;

Eigen::Vector2d vector_of(const Point2& p) { return {p.x_m, p.y_m}; }

}  // namespace

MotionSense::MotionSense(const Configuration& configuration, const CameraModel& camera)
    : camera_(camera),
      tracker_(configuration.motion, camera.width_px, camera.height_px,
               static_cast<std::size_t>(configuration.flow.corners.max_features)),
      map_(configuration.activity_map) {
  on_ground_.reserve(static_cast<std::size_t>(configuration.motion.tracker.max_tracks));
}

void MotionSense::see(std::span<const FlowVector> vectors, const Pose2& X_WB) {
  tracker_.update(vectors);
  on_ground_.clear();
  for (const Track& track : report().tracks) {
    const GroundMotion ground = project(track, X_WB);
    on_ground_.push_back(ground);
    if (track.unseen_frames == 0) map_.add(ground.p_W_m, ground.v_W_m);
  }
}

/// Its velocity over the ground is that of a second point, one frame of motion away.
GroundMotion MotionSense::project(const Track& track, const Pose2& X_WB) const {
  const double x = track.at_px.x_px, y = track.at_px.y_px + track.half_size_px.y_px;
  const std::optional<Point2> foot = ground_point(camera_, {x, y});
  const std::optional<Point2> next = ground_point(camera_, {x + track.v_px.x_px, y + track.v_px.y_px});
  if (!foot || !next || std::hypot(foot->x_m, foot->y_m) > kFarthest_m) {
    const auto nowhere = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
    return {nowhere, nowhere};
  }
  const Eigen::Vector2d p_W = vector_of(X_WB * *foot);
  return {p_W, vector_of(X_WB * *next) - p_W};
}

}  // namespace hindsight
