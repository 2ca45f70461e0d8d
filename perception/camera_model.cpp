// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/camera_model.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "config/exit_code.h"

namespace hindsight {
namespace {

constexpr int kMaxIterations = 100;
constexpr double kConverged = 1e-13;

double radial_factor(const std::array<double, 8>& k, double r2) {
  return (1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))) / (1 + r2 * (k[5] + r2 * (k[6] + r2 * k[7])));
}

Eigen::Vector2d tangential_shift(const std::array<double, 8>& k, const Eigen::Vector2d& p) {
  const double xy2 = 2 * p.x() * p.y();
  const double r2 = p.squaredNorm();
  return {k[2] * xy2 + k[3] * (r2 + 2 * p.x() * p.x()), k[2] * (r2 + 2 * p.y() * p.y()) + k[3] * xy2};
}

Eigen::Vector2d distort(const std::array<double, 8>& k, const Eigen::Vector2d& p) {
  return p * radial_factor(k, p.squaredNorm()) + tangential_shift(k, p);
}

/// Inverse of distort() by OpenCV's fixed-point iteration.
Eigen::Vector2d undistort(const std::array<double, 8>& k, const Eigen::Vector2d& distorted) {
  Eigen::Vector2d p = distorted;
  for (int i = 0; i < kMaxIterations; ++i) {
    const Eigen::Vector2d next = (distorted - tangential_shift(k, p)) / radial_factor(k, p.squaredNorm());
    const double change = (next - p).squaredNorm();
    p = next;
    if (change < kConverged * kConverged) break;
  }
  return p;
}

Eigen::Vector2d tangents_of(const CameraModel& camera, ImagePoint pixel) {
  return undistort(camera.distortion,
                   {(pixel.x_px - camera.cx_px) / camera.fx_px, (pixel.y_px - camera.cy_px) / camera.fy_px});
}

}  // namespace

std::optional<ImagePoint> CameraModel::project(const Eigen::Vector3d& p_BP_m) const {
  const Eigen::Vector3d p_CP_m = R_BC.transpose() * (p_BP_m - p_BC_m);
  constexpr double kNearestDepth_m = 1e-3;
  if (!(p_CP_m.z() > kNearestDepth_m)) return std::nullopt;
  const Eigen::Vector2d tangents = p_CP_m.head<2>() / p_CP_m.z();
  const double beyond = std::max(1.0, tangents.norm() / max_tan);
  const Eigen::Vector2d d = distort(distortion, tangents / beyond) * beyond;
  return ImagePoint{fx_px * d.x() + cx_px, fy_px * d.y() + cy_px};
}

Eigen::Vector3d CameraModel::ray_B(ImagePoint pixel) const {
  return R_BC * tangents_of(*this, pixel).homogeneous();
}

void CameraModel::require_size(int picture_width_px, int picture_height_px) const {
  if (picture_width_px == width_px && picture_height_px == height_px) return;
  throw FatalError(kExitBadData,
                   fmt::format("{}: the calibration is for pictures of {} x {} pixels, but these are {} x {}",
                               name, width_px, height_px, picture_width_px, picture_height_px));
}

void CameraModel::set_orientation(double roll_rad, double pitch_rad, double yaw_rad) {
  Eigen::Matrix3d forward_left_up_from_C;  // the axes of C in a body frame that looks along the optical axis
  forward_left_up_from_C << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  R_BC = (Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX()))
             .toRotationMatrix() *
         forward_left_up_from_C;
}

void CameraModel::set_field_of_view() {
  max_tan = 0.0;
  const auto widen = [this](int x_px, int y_px) {
    max_tan = std::max(max_tan, tangents_of(*this, {x_px - 0.5, y_px - 0.5}).norm());
  };
  for (int x = 0; x <= width_px; ++x) widen(x, 0), widen(x, height_px);
  for (int y = 0; y <= height_px; ++y) widen(0, y), widen(width_px, y);
}

}  // namespace hindsight
