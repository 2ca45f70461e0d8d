// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/traceback_evaluation.h"

#include <algorithm>
#include <memory>

#include "perception/optical_flow.h"
#include "tools/opencv_flow.h"

namespace hindsight::tools {
namespace {

constexpr double kHorizonRow = 0.45;  // of the image's height
constexpr int kShortestTrack = 10;

void trace_all(std::span<const ReferenceTrack> tracks, int image_height_px, TracebackArm& arm) {
  for (const ReferenceTrack& track : tracks) {
    const int frames = std::min(static_cast<int>(track.size()) - 1, arm.history.size());
    const cv::Point2f end = track.back();
    if (frames < kShortestTrack || end.y < kHorizonRow * image_height_px) continue;
    const FlowHistory::Trace trace = arm.history.trace_back({end.x, end.y}, frames);
    const cv::Point2f truth = track[track.size() - 1 - static_cast<std::size_t>(frames)];
    arm.errors.push_back({frames, cv::norm(cv::Point2f(trace.point_px.x_px, trace.point_px.y_px) - truth)});
  }
}

double quantile(std::vector<double> values, double share) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

TracebackArm hindsight_arm(std::string name, const OpticalFlowParams& flow, const FlowHistoryParams& history,
                           cv::Size image) {
  auto optical_flow = std::make_shared<OpticalFlow>(flow, image.width, image.height);
  return {std::move(name),
          [optical_flow](const cv::Mat& bgr) {
            return optical_flow->update({bgr.data, bgr.total() * bgr.elemSize()});
          },
          FlowHistory(history, image.width, image.height),
          {}};
}

TracebackArm opencv_arm(std::string name, const OpticalFlowParams& flow, const FlowHistoryParams& history,
                        cv::Size image) {
  auto opencv_flow = std::make_shared<OpencvFlow>(flow);
  return {std::move(name),
          [opencv_flow](const cv::Mat& bgr) { return opencv_flow->update(bgr); },
          FlowHistory(history, image.width, image.height),
          {}};
}

void evaluate_traceback(ImageFolder& frames, std::vector<TracebackArm>& arms,
                        const std::function<void(int)>& progress) {
  ReferenceTracks reference;
  int height_px = 0;
  for (int t = 0; t < frames.size(); ++t) {
    const cv::Mat bgr = frames.read(t);
    height_px = bgr.rows;
    const std::vector<ReferenceTrack> ended = reference.advance(bgr);
    for (TracebackArm& arm : arms) {
      trace_all(ended, height_px, arm);  // they ended in the frame before, the newest that the history knows
      const std::span<const FlowVector> flow = arm.flow(bgr);
      if (t > 0) arm.history.push(flow);
    }
    progress(t + 1);
  }
  for (TracebackArm& arm : arms) trace_all(reference.alive(), height_px, arm);
}

TracebackSummary summarise(std::span<const TracebackArm::Error> errors, int min_frames) {
  std::vector<double> px;
  for (const auto& error : errors) {
    if (error.frames >= min_frames) px.push_back(error.px);
  }
  if (px.empty()) return {};
  return {quantile(px, 0.5), quantile(px, 0.75), static_cast<int>(px.size())};
}

}  // namespace hindsight::tools
