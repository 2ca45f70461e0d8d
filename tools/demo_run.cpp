// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/demo_run.h"

#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <utility>

#include "daemon/run_setup.h"
#include "drivers/frame_decoder.h"
#include "tools/builtin_config.h"

namespace hindsight::tools {
namespace {

constexpr Time kStart = from_seconds(1.0);
/// 2026-01-01 00:00 UTC; a run that repeats bit for bit has no date of its own.
constexpr std::int64_t kStartUtime_us = 1'767'225'600'000'000;
constexpr double kGoalEast_m = 25.0;
/// The first frames settle before the robot is told to go.
constexpr std::uint64_t kOrdersAtTick = 5;
constexpr int kJpegQuality = 92;

RunHeader materials_for(const Configuration& configuration) {
  RunHeader materials;
  materials.utime_us = kStartUtime_us;
  materials.build_id = build_id();
  materials.configuration = to_text(configuration);
  materials.dbc = builtin_dbc();
  materials.calibration = builtin_calibration();
  return materials;
}

DemoCamera camera_of(const CameraModel& model) {
  DemoCamera camera{.width_px = model.width_px,
                    .height_px = model.height_px,
                    .fx_px = model.fx_px,
                    .fy_px = model.fy_px,
                    .cx_px = model.cx_px,
                    .cy_px = model.cy_px};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      camera.R_BC[static_cast<std::size_t>(3 * row + column)] = model.R_BC(row, column);
    }
    camera.p_BC_m[static_cast<std::size_t>(row)] = model.p_BC_m(row);
  }
  return camera;
}

}  // namespace

DemoRun::DemoRun(const Configuration& configuration, std::uint64_t seed)
    : materials_(materials_for(configuration)),
      setup_(make_setup(configuration, materials_, "demo")),
      world_(make_demo_world(kGoalEast_m, seed)),
      scene_(world_, camera_of(setup_.camera), seed),
      vehicle_(configuration.vehicle, world_, setup_.dbc, configuration.can_roles, seed),
      reflex_(configuration),
      robot_(setup_),
      pool_(2, 0, 0),
      period_(from_seconds(1.0 / configuration.robot.loop_rate_hz)) {
  input_.reserve();
  moment_.reserve();
  input_.now = kStart;
  input_.utime_us = kStartUtime_us;
  vehicle_.report_lines(kStart, input_.edges);
}

void DemoRun::step() {
  let_the_world_move();
  take_picture();
  if (input_.index == kOrdersAtTick) give_orders();
  outbox_.clear();
  const Decision decision = robot_.step(input_, outbox_);
  reflex_.decide(decision);
  for (const Lesson& lesson : robot_.learner().lessons()) components_learnt_ += lesson.report.new_components;
}

/// One tick's period, in the vehicle's steps: what the reflex lets through in one drives the wheels in the
/// next.
void DemoRun::let_the_world_move() {
  if (std::exchange(began_, true)) {
    input_.clear();
    ++input_.index;
  }
  const Time until = input_.now + period_;
  while (input_.now + DemoVehicle::kPeriod <= until) {
    input_.now += DemoVehicle::kPeriod;
    moment_.clear();
    moment_.now = input_.now;
    vehicle_.step(input_.now, input_.reflex.left_mps, input_.reflex.right_mps, moment_);
    reflex_.run_up_to(moment_);
    input_.reflex = moment_.reflex;
    input_.can.insert(input_.can.end(), moment_.can.begin(), moment_.can.end());
    input_.edges.insert(input_.edges.end(), moment_.edges.begin(), moment_.edges.end());
  }
  input_.utime_us = kStartUtime_us + (input_.now - kStart).count() / 1000;
}

void DemoRun::take_picture() {
  const std::span<const std::uint8_t> bgr = scene_.render(vehicle_.pose());
  FrameRef ref = pool_.take();
  Frame& frame = ref.writable();
  frame.stamp = input_.now;
  frame.sequence = static_cast<std::uint32_t>(input_.index);
  frame.format = PixelFormat::mjpeg;
  frame.width_px = setup_.camera.width_px;
  frame.height_px = setup_.camera.height_px;
  const cv::Mat picture(frame.height_px, frame.width_px, CV_8UC3, const_cast<std::uint8_t*>(bgr.data()));
  cv::imencode(".jpg", picture, frame.bytes, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  decode_frame(frame);
  input_.frame = std::move(ref);
}

void DemoRun::give_orders() {
  input_.commands.push_back({input_.now, CommandKind::go_to_local, kGoalEast_m, 0.0, 1});
  input_.commands.push_back({input_.now, CommandKind::arm, 0.0, 0.0, 2});
}

void DemoRun::record(RunLogWriter& log) const {
  log.write_tick(input_);
  for (const Outbox::Message& message : outbox_.messages()) {
    log.write_published(message.channel, message.utime_us, message.bytes);
  }
  log.flush();
}

DemoSummary DemoRun::summary() const {
  DemoSummary summary;
  const DemoPose& true_pose = vehicle_.pose();
  const Pose2& believed = robot_.localisation().estimate().X_WB;
  summary.ticks = static_cast<int>(input_.index) + 1;
  summary.seconds = to_seconds(input_.now - kStart);
  summary.to_goal_m = std::hypot(kGoalEast_m - true_pose.x_m, true_pose.y_m);
  summary.drift_m = std::hypot(believed.x_m - true_pose.x_m, believed.y_m - true_pose.y_m);
  summary.touches = vehicle_.touches();
  summary.components_learnt = components_learnt_;
  summary.behaviour = robot_.plan().behaviour;
  summary.reached = robot_.plan().reached;
  return summary;
}

}  // namespace hindsight::tools
