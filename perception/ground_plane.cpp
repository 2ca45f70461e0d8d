// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/ground_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hindsight {
namespace {

constexpr float kNoGround = std::numeric_limits<float>::quiet_NaN();

/// How steeply a pixel looks up; negative where it sees ground.
double steepness(const CameraModel& camera, int column, int row) {
  return camera.ray_B({static_cast<double>(column), static_cast<double>(row)}).z();
}

float horizon_row(const CameraModel& camera, int column) {
  double below = steepness(camera, column, camera.height_px - 1);
  if (below >= 0.0) return static_cast<float>(camera.height_px) - 0.5F;
  for (int row = camera.height_px - 2; row >= 0; --row) {
    const double here = steepness(camera, column, row);
    if (here >= 0.0) return static_cast<float>(row + here / (here - below));
    below = here;
  }
  return -0.5F;
}

}  // namespace

std::optional<Point2> ground_point(const CameraModel& camera, ImagePoint pixel) {
  const Eigen::Vector3d ray = camera.ray_B(pixel);
  if (!(ray.z() < 0.0)) return std::nullopt;
  const double length = -camera.p_BC_m.z() / ray.z();
  return Point2{camera.p_BC_m.x() + length * ray.x(), camera.p_BC_m.y() + length * ray.y()};
}

GroundPlane::GroundPlane(const CameraModel& camera, double max_range_m)
    : width_px_(camera.width_px), height_px_(camera.height_px) {
  table_.reserve(static_cast<std::size_t>(width_px_) * static_cast<std::size_t>(height_px_));
  for (int row = 0; row < height_px_; ++row) {
    for (int column = 0; column < width_px_; ++column) {
      const auto p = ground_point(camera, {static_cast<double>(column), static_cast<double>(row)});
      const bool seen = p && std::hypot(p->x_m, p->y_m) <= max_range_m;
      table_.push_back(seen ? GroundPoint{static_cast<float>(p->x_m), static_cast<float>(p->y_m)}
                            : GroundPoint{kNoGround, kNoGround});
    }
  }
  horizon_row_px_.reserve(static_cast<std::size_t>(width_px_));
  for (int column = 0; column < width_px_; ++column) horizon_row_px_.push_back(horizon_row(camera, column));
}

}  // namespace hindsight
