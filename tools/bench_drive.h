// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <opencv2/core/mat.hpp>
#include <span>

#include "daemon/robot.h"
#include "drivers/frame_pool.h"
#include "drivers/vehicle_base_codec.h"
#include "sim_replay/run_header.h"

namespace hindsight::tools {

/// A drive to measure on: given frames at 10 Hz, forth and back so that it can last, wheel speeds and motor currents
/// at 20 Hz, armed and with a goal in the second tick. Touches nothing after that: a steady state.
class BenchDrive {
 public:
  /// Frames: CV_8UC3, continuous, all of the size of config/camera.yaml.
  explicit BenchDrive(std::span<const cv::Mat> bgr_frames);

  void fill(std::uint64_t tick, TickInput& input);

  /// A robot of the given configuration with the built-in camera and CAN protocol.
  static RobotSetup setup(const Configuration& configuration);
  /// What a log of the drive has in its header.
  static RunHeader header(const Configuration& configuration);

 private:
  FramePool pool_;  // before the references into it
  std::vector<FrameRef> frames_;
  VehicleBaseCodec codec_;
  VehicleSignals signals_;
};

}  // namespace hindsight::tools
