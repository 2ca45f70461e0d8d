// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/aerial_camera.h"

#include <cmath>

#include "sim_replay/world/random.h"

namespace hindsight::tools {
namespace {

cv::Matx33d rotation(double about_x, double about_y, double about_z) {
  const double cx = std::cos(about_x), sx = std::sin(about_x), cy = std::cos(about_y), sy = std::sin(about_y),
               cz = std::cos(about_z), sz = std::sin(about_z);
  return cv::Matx33d(1, 0, 0, 0, cx, -sx, 0, sx, cx) * cv::Matx33d(cy, 0, sy, 0, 1, 0, -sy, 0, cy) *
         cv::Matx33d(cz, -sz, 0, sz, cz, 0, 0, 0, 1);
}

}  // namespace

cv::Point2d turned(cv::Point2d p, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

AerialCamera::AerialCamera(std::uint64_t seed, cv::Point2d over_m, double height_m, double yaw_rad,
                           double tilt_rad)
    : over_m_(over_m), height_m_(height_m), yaw_rad_(yaw_rad), tilt_rad_(tilt_rad) {
  Random random(seed, 3);
  for (const double amplitude : {1.2, 1.2, 0.6, 0.012, 0.012, 0.02}) {
    sways_.push_back({amplitude, random.uniform(0.03, 0.08), random.uniform(0.0, 2.0 * CV_PI)});
    sways_.push_back({0.2 * amplitude, random.uniform(0.2, 0.6), random.uniform(0.0, 2.0 * CV_PI)});
  }
}

double AerialCamera::Sway::at(double t_s) const {
  return amplitude * std::sin(2.0 * CV_PI * hz * t_s + phase_rad);
}

double AerialCamera::sum(std::size_t axis, double t_s) const {
  return sways_[2 * axis].at(t_s) + sways_[2 * axis + 1].at(t_s);
}

cv::Vec3d AerialCamera::place_m(double t_s) const {
  const cv::Point2d back = turned({0.0, -height_m_ * std::tan(tilt_rad_)}, yaw_rad_);
  return {over_m_.x + back.x + sum(0, t_s), over_m_.y + back.y + sum(1, t_s), height_m_ + sum(2, t_s)};
}

cv::Matx34d AerialCamera::projection(double t_s) const {
  // Looking straight down with the picture's top to the north: x right = east, y down = south, z = down.
  const cv::Matx33d down(1, 0, 0, 0, -1, 0, 0, 0, -1);
  const cv::Matx33d R = rotation(tilt_rad_ + sum(3, t_s), sum(4, t_s), 0.0) * down *
                        rotation(0.0, 0.0, -(yaw_rad_ + sum(5, t_s)));
  const cv::Vec3d t = -(R * place_m(t_s));
  const cv::Matx33d K(kFocal_px, 0, 0.5 * kWidth_px, 0, kFocal_px, 0.5 * kHeight_px, 0, 0, 1);
  return K * cv::Matx34d(R(0, 0), R(0, 1), R(0, 2), t[0], R(1, 0), R(1, 1), R(1, 2), t[1], R(2, 0), R(2, 1),
                         R(2, 2), t[2]);
}

cv::Matx33d ground_homography(const cv::Matx34d& P) {
  return {P(0, 0), P(0, 1), P(0, 3), P(1, 0), P(1, 1), P(1, 3), P(2, 0), P(2, 1), P(2, 3)};
}

}  // namespace hindsight::tools
