// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A run as a film: what the robot saw, drawn over, beside its map as it grew.
#pragma once

#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

#include "daemon/replay_run.h"
#include "tools/report_trace.h"

namespace hindsight::tools {

class ReportVideo {
 public:
  /// H.264 in MP4, one picture a frame at the loop's rate; where this machine's FFmpeg has no encoder for it,
  /// Motion JPEG in AVI. `stem`: path without ending. FatalError 74 where neither can be written.
  ReportVideo(const std::string& stem, double rate_hz, cv::Size frame);

  /// The tick that `run` has just stepped through; nothing where it had no frame.
  void look(ReplayRun& run, const RunTrace& trace);

  const std::string& path() const { return path_; }

 private:
  bool open(const std::string& path, int fourcc, double rate_hz);
  cv::Mat draw_surroundings(ReplayRun& run, const RunTrace& trace) const;

  cv::Size frame_;
  cv::Mat canvas_;
  cv::VideoWriter writer_;
  std::string path_;
};

}  // namespace hindsight::tools
