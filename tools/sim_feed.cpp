// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/sim_feed.h"

#include <opencv2/imgcodecs.hpp>
#include <utility>

#include "drivers/frame_decoder.h"

namespace hindsight::tools {
namespace {

constexpr int kJpegQuality = 92;

}  // namespace

RenderCamera render_camera(const CameraModel& model) {
  RenderCamera camera{.width_px = model.width_px,
                      .height_px = model.height_px,
                      .fx_px = model.fx_px,
                      .fy_px = model.fy_px,
                      .cx_px = model.cx_px,
                      .cy_px = model.cy_px,
                      .distortion = model.distortion};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      camera.R_BC[static_cast<std::size_t>(3 * row + column)] = model.R_BC(row, column);
    }
    camera.p_BC_m[static_cast<std::size_t>(row)] = model.p_BC_m(row);
  }
  return camera;
}

SimFeed::SimFeed(const RobotSetup& setup, const World& world, std::uint64_t seed, bool truth)
    : world_(world),
      camera_(render_camera(setup.camera)),
      renderer_(world_, camera_, seed),
      vehicle_(setup.configuration.vehicle, world_, setup.dbc, setup.configuration.can_roles,
               setup.configuration.training.ir_threshold_m, seed),
      pool_(2, 0, 0),
      period_(from_seconds(1.0 / setup.configuration.robot.loop_rate_hz)),
      X_WB_(vehicle_.pose()),
      X_WB_before_(X_WB_),
      truth_(truth) {
  moment_.reserve();
}

void SimFeed::begin_tick(TickInput& input) {
  input.clear();
  if (std::exchange(began_, true)) {
    ++input.index;
    return;
  }
  input.reserve();
  input.now = kStart;
  vehicle_.report_lines(kStart, input.edges);
}

void SimFeed::move(TickInput& input) {
  input.now += SimVehicle::kPeriod;
  input.utime_us = kStartUtime_us + (input.now - kStart).count() / 1000;
  moment_.clear();
  moment_.now = input.now;
  vehicle_.step(input.now, command_, moment_);
  input.can.insert(input.can.end(), moment_.can.begin(), moment_.can.end());
  input.edges.insert(input.edges.end(), moment_.edges.begin(), moment_.edges.end());
  input.fixes.insert(input.fixes.end(), moment_.fixes.begin(), moment_.fixes.end());
}

void SimFeed::take_picture(TickInput& input) {
  X_WB_before_ = std::exchange(X_WB_, vehicle_.pose());
  rendered_ =
      &renderer_.render(X_WB_, X_WB_before_, to_seconds(period_), to_seconds(input.now - kStart), truth_);
  FrameRef ref = pool_.take();
  Frame& frame = ref.writable();
  frame.stamp = input.now;
  frame.sequence = static_cast<std::uint32_t>(input.index);
  frame.format = PixelFormat::mjpeg;
  frame.width_px = camera_.width_px;
  frame.height_px = camera_.height_px;
  frame.exposure_s = rendered_->exposure_s;
  frame.gain = rendered_->gain;
  const cv::Mat picture(frame.height_px, frame.width_px, CV_8UC3,
                        const_cast<std::uint8_t*>(rendered_->bgr.data()));
  cv::imencode(".jpg", picture, frame.bytes, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  decode_frame(frame);
  input.frame = std::move(ref);
}

}  // namespace hindsight::tools
