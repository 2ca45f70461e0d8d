// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The camera: what pixel a point of the body frame falls on, and which way a pixel looks.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace hindsight {

/// A point of the picture: x right, y down, the centre of the top left pixel at (0, 0), as OpenCV has it.
struct ImagePoint {
  double x_px = 0.0;
  double y_px = 0.0;
};

/// Columns [x, x + width) and rows [y, y + height) of the picture.
struct ImageRect {
  float x_px = 0.0F;
  float y_px = 0.0F;
  float width_px = 0.0F;
  float height_px = 0.0F;
  bool operator==(const ImageRect&) const = default;
};

/// What a near-range sensor touches, as a region of the picture that a calibration may give by hand.
enum class NearPatch : std::uint8_t {
  bumper_left = 0,
  bumper_right = 1,
  ir_left = 2,
  ir_right = 3,
  ahead = 4,
  bumper_both = 5
};
constexpr int kNearPatchCount = 6;

/// Pinhole with OpenCV's distortion, mounted on the body. C is the camera frame: x right, y down, z forward.
struct CameraModel {
  std::string name;  ///< where it was read from, for messages
  int width_px = 0;
  int height_px = 0;
  double fx_px = 0.0;
  double fy_px = 0.0;
  double cx_px = 0.0;
  double cy_px = 0.0;
  std::array<double, 8> distortion{};  ///< k1 k2 p1 p2 k3 k4 k5 k6; absent ones are 0
  Eigen::Matrix3d R_BC = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p_BC_m = Eigen::Vector3d::Zero();
  double max_tan =
      0.0;  ///< the widest tan(angle to the optical axis) in the picture; see set_field_of_view()
  std::array<std::optional<ImageRect>, kNearPatchCount> patches;  ///< regions given by hand

  /// Pixel of a point of B, which may lie outside of the picture; empty behind the camera. The distortion
  /// polynomial is fitted within the picture and may fold back outside of it: from max_tan on it is continued
  /// linearly.
  std::optional<ImagePoint> project(const Eigen::Vector3d& p_BP_m) const;
  /// Direction in B in which a pixel looks, with length 1 along the optical axis; it starts at p_BC_m.
  Eigen::Vector3d ray_B(ImagePoint pixel) const;
  /// Throws FatalError(65) naming both sizes unless the pictures have the size that was calibrated.
  void require_size(int picture_width_px, int picture_height_px) const;
  /// Sets R_BC from the angles of a calibration file: yaw positive to the left, pitch positive downwards,
  /// roll positive with the right side down, applied in this order.
  void set_orientation(double roll_rad, double pitch_rad, double yaw_rad);
  /// Sets max_tan; to be called once intrinsics and size are there. The parsers below do.
  void set_field_of_view();
};

/// From YAML text: OpenCV's calibration keys (image_width, image_height, camera_matrix,
/// distortion_coefficients), as written by OpenCV's calibration sample or as ROS' camera_info has them, and
/// ours: p_BC_m [x, y, z], camera_roll_rad, camera_pitch_rad, camera_yaw_rad, and optionally `patches`
/// (config/camera.yaml explains them). `name` stands for the text in messages. Throws FatalError(65) naming
/// text, key and what was expected.
CameraModel parse_camera_model(const std::string& yaml, const std::string& name);

/// The same from a file; FatalError(66) where it cannot be read.
CameraModel read_camera_model(const std::filesystem::path& path);

}  // namespace hindsight
