// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// How far tracebacks through the flow grid end from where the same places really were.
#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>
#include <span>
#include <string>
#include <vector>

#include "perception/flow_history.h"
#include "perception/flow_vector.h"
#include "perception/optical_flow_params.h"
#include "tools/image_folder.h"
#include "tools/reference_tracks.h"

namespace hindsight::tools {

/// One way of making flow, with the history that it fills and the errors of the tracebacks through that.
struct TracebackArm {
  struct Error {
    int frames = 0;
    double px = 0.0;
  };
  std::string name;
  std::function<std::span<const FlowVector>(const cv::Mat& bgr)> flow;
  FlowHistory history;
  std::vector<Error> errors;
};

/// This project's flow.
TracebackArm hindsight_arm(std::string name, const OpticalFlowParams& flow, const FlowHistoryParams& history,
                           cv::Size image);

/// OpenCV's smoothing, corners and tracker with the same parameters, into the same history.
TracebackArm opencv_arm(std::string name, const OpticalFlowParams& flow, const FlowHistoryParams& history,
                        cv::Size image);

/// Runs all arms over the frames. Each reference track that ends below the horizon is traced back from its
/// end to its beginning (at most to the oldest frame that the history holds); the error is the distance
/// between the two in pixels of the frames. "Below the horizon" is: rows below 45 % of the image's height, as
/// nothing is known of the camera. `progress` is called with the number of frames done.
void evaluate_traceback(ImageFolder& frames, std::vector<TracebackArm>& arms,
                        const std::function<void(int)>& progress);

/// Median and upper quartile of the errors over tracks of at least `min_frames` frames; without one, tracks =
/// 0.
struct TracebackSummary {
  double median_px = 0.0;
  double p75_px = 0.0;
  int tracks = 0;
};
TracebackSummary summarise(std::span<const TracebackArm::Error> errors, int min_frames);

}  // namespace hindsight::tools
