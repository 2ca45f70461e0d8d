// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_video.h"

#include <fmt/format.h>

#include <opencv2/imgproc.hpp>

#include "config/exit_code.h"
#include "tools/report_frame.h"
#include "tools/report_map.h"

namespace hindsight::tools {
namespace {

constexpr double kMapSide_m = 40.0;

}  // namespace

ReportVideo::ReportVideo(const std::string& stem, double rate_hz, cv::Size frame)
    : frame_(frame), canvas_(frame.height, frame.width + frame.height, CV_8UC3) {
  if (open(stem + ".mp4", cv::VideoWriter::fourcc('a', 'v', 'c', '1'), rate_hz)) return;
  if (open(stem + ".avi", cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), rate_hz)) return;
  throw FatalError(kExitIo, stem + ".avi: cannot write a video");
}

bool ReportVideo::open(const std::string& path, int fourcc, double rate_hz) {
  path_ = path;
  return writer_.open(path, fourcc, rate_hz, canvas_.size());
}

void ReportVideo::look(ReplayRun& run, const RunTrace& trace) {
  const FrameRef& frame = run.input().frame;
  if (!frame || cv::Size(frame->width_px, frame->height_px) != frame_) return;
  draw_frame(*frame, run.robot(), touched_patches(run.robot().learner().lessons()))
      .copyTo(canvas_(cv::Rect({0, 0}, frame_)));
  draw_surroundings(run, trace).copyTo(canvas_(cv::Rect(frame_.width, 0, frame_.height, frame_.height)));
  writer_.write(canvas_);
}

/// A square of the map with the robot in its middle.
cv::Mat ReportVideo::draw_surroundings(ReplayRun& run, const RunTrace& trace) const {
  const MapScene scene = scene_of(run, trace);
  const double half_m = kMapSide_m / 2;
  const MapView view({scene.X_WB.x_m - half_m, scene.X_WB.y_m - half_m},
                     {scene.X_WB.x_m + half_m, scene.X_WB.y_m + half_m}, frame_.height / kMapSide_m);
  cv::Mat map = draw_map(scene, view);
  cv::resize(map, map, {frame_.height, frame_.height});
  return map;
}

}  // namespace hindsight::tools
