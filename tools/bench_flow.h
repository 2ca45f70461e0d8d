// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <opencv2/core/mat.hpp>
#include <span>

#include "perception/flow_history.h"
#include "perception/optical_flow_params.h"

namespace hindsight::tools {

/// Medians over the frames, in milliseconds.
struct FlowBench {
  double opencv_ms =
      0.0;  ///< GaussianBlur + goodFeaturesToTrack + calcOpticalFlowPyrLK on grey frames, thesis values
  double thesis_ms = 0.0;   ///< OpticalFlow::update + FlowHistory::push on BGR frames, thesis values
  double default_ms = 0.0;  ///< the same with the defaults
};

/// Times the three on the same consecutive frames (8-bit BGR, continuous, one size), frame by frame in turn,
/// so that whatever else the machine does falls on all of them. Needs at least two frames.
FlowBench bench_flow(std::span<const cv::Mat> bgr_frames, const OpticalFlowParams& thesis_flow,
                     const FlowHistoryParams& thesis_history, const OpticalFlowParams& default_flow,
                     const FlowHistoryParams& default_history);

}  // namespace hindsight::tools
