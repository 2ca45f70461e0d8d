// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A camera on a platform in the air.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace hindsight::tools {

/// A platform that tries to hover: it drifts and sways as sums of slow waves of random phase. 640 x 480
/// pixels.
class AerialCamera {
 public:
  static constexpr int kWidth_px = 640, kHeight_px = 480;
  static constexpr double kFocal_px = 640.0;

  /// Above `over_m`, turned by `yaw_rad`, looking down but for `tilt_rad`.
  AerialCamera(std::uint64_t seed, cv::Point2d over_m, double height_m, double yaw_rad, double tilt_rad);

  /// 3 x 4: homogeneous points of the world to pixels.
  cv::Matx34d projection(double t_s) const;
  cv::Vec3d place_m(double t_s) const;

 private:
  struct Sway {
    double amplitude = 0.0, hz = 0.0, phase_rad = 0.0;
    double at(double t_s) const;
  };
  double sum(std::size_t axis, double t_s) const;
  cv::Point2d over_m_;
  double height_m_, yaw_rad_, tilt_rad_;
  std::vector<Sway> sways_;  ///< two of each: x, y, z, roll, pitch, yaw
};

/// World points of the plane z = 0 to pixels.
cv::Matx33d ground_homography(const cv::Matx34d& projection);

/// A point turned counter-clockwise about the origin.
cv::Point2d turned(cv::Point2d p, double angle_rad);

}  // namespace hindsight::tools
