// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <opencv2/core/mat.hpp>
#include <span>

#include "daemon/robot_config.h"

namespace hindsight::tools {

/// The whole tick against OpenCV's flow alone, in turn on the same frames: medians of the thread's processor time.
struct TickBench {
  double tick_thesis_ms = 0.0;
  double tick_default_ms = 0.0;
  double opencv_thesis_ms = 0.0;   ///< smoothing + corners + Lucas-Kanade on grey frames, the thesis' parameters
  double opencv_default_ms = 0.0;  ///< the same with the default parameters
  double allocations_per_tick = 0.0;  ///< of the default configuration, most of any tick in the steady state
};
TickBench bench_tick(std::span<const cv::Mat> bgr_frames, const Configuration& thesis, const Configuration& standard);

/// Resident memory [MB] of a process that has run a robot until its history is full. Runs in a child process, so
/// call it before anything large is loaded.
double bench_resident_mb(std::span<const cv::Mat> bgr_frames, const Configuration& configuration);

/// Duration of a recorded 10 Hz run (JPEG frames) over the time that its replay takes.
double bench_replay_over_realtime(std::span<const cv::Mat> bgr_frames, const Configuration& configuration);

}  // namespace hindsight::tools
