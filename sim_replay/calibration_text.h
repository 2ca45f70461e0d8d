// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>

namespace hindsight {

/// A camera calibration as text for a run log's header, with the picture size that it is for. All else in it
/// is read by whoever uses it.
struct CalibrationText {
  std::string text;
  int width_px = 0;
  int height_px = 0;
};

/// Reads a YAML file of OpenCV's or ROS's kind. Throws FatalError 66 where it cannot be read, 65 where it has
/// no `image_width` or `image_height`.
CalibrationText read_calibration_text(const std::filesystem::path& path);

}  // namespace hindsight
