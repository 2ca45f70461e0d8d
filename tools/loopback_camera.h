// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The world's end of a v4l2loopback device: what is written here is what the robot's camera captures.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "drivers/unique_fd.h"
#include "drivers/v4l2_stream.h"

namespace hindsight::tools {

/// One thread.
class LoopbackCamera {
 public:
  /// Opens the output device that params.device names and sets it to that size and format, so that a robot
  /// with the same configuration finds the camera that it asks for. FatalError(kExitNoDevice) where the
  /// device is absent, busy or no video output.
  explicit LoopbackCamera(const CameraFormatParams& params);

  /// A picture as such a camera sends it. `bgr`: row-major, 3 bytes a pixel, of the size given at
  /// construction.
  std::vector<std::uint8_t> encode(std::span<const std::uint8_t> bgr) const;
  /// Shows an encoded picture. FatalError(kExitIo) where the device does not take it.
  void show(std::span<const std::uint8_t> encoded);

 private:
  void set_format();

  CameraFormatParams params_;
  PixelFormat format_;
  UniqueFd device_;
};

}  // namespace hindsight::tools
