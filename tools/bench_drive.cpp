// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/bench_drive.h"

#include <cmath>

#include "daemon/run_setup.h"
#include "tools/builtin_config.h"

namespace hindsight::tools {
namespace {

constexpr Time kPeriod = from_seconds(0.1);
constexpr Time kStart = from_seconds(1.0);
constexpr double kSpeed_mps = 1.0;

}  // namespace

BenchDrive::BenchDrive(std::span<const cv::Mat> bgr_frames)
    : pool_(bgr_frames.size(), 0, 0), codec_(parse_dbc(builtin_dbc(), "lagr.dbc"), CanRolesParams{}) {
  for (const cv::Mat& bgr : bgr_frames) {
    FrameRef taken = pool_.take();
    if (!taken) return;  // cannot be: the pool has a slot for each
    Frame& frame = taken.writable();
    frame.format = PixelFormat::bgr24;
    frame.width_px = bgr.cols;
    frame.height_px = bgr.rows;
    frame.bgr.assign(bgr.datastart, bgr.dataend);
    frames_.push_back(std::move(taken));
  }
}

void BenchDrive::fill(std::uint64_t tick, TickInput& input) {
  input.clear();
  input.index = tick;
  input.now = kStart + static_cast<std::int64_t>(tick) * kPeriod;
  input.utime_us = input.now.count() / 1000;
  const std::uint64_t turn = 2 * frames_.size() - 2;
  const std::uint64_t place = turn == 0 ? 0 : tick % turn;
  FrameRef frame = frames_[place < frames_.size() ? place : turn - place];
  frame.writable().stamp = input.now;
  frame.writable().sequence = static_cast<std::uint32_t>(tick);
  input.frame = frame;
  for (int half = 1; half >= 0; --half) {
    const Time stamp = input.now - half * kPeriod / 2;
    signals_.left_mps = signals_.right_mps = kSpeed_mps;
    signals_.left_a = signals_.right_a = 6.0 + std::sin(2.0 * M_PI * 0.7 * to_seconds(stamp));
    signals_.ir_left_m = signals_.ir_right_m = 2.0;
    for (SignalGroup group : {SignalGroup::wheels, SignalGroup::currents, SignalGroup::ir_ranges}) {
      codec_.encode(group, signals_, stamp, input.can);
    }
  }
  if (tick == 0) {
    for (Line line : {Line::bumper_left, Line::bumper_right, Line::estop}) input.edges.push_back({input.now, line, false});
  }
  if (tick == 1) {
    input.commands.push_back({input.now, CommandKind::arm, 0.0, 0.0, 1});
    input.commands.push_back({input.now, CommandKind::go_to_local, 40.0, 3.0, 2});
  }
}

RunHeader BenchDrive::header(const Configuration& configuration) {
  RunHeader header;
  header.build_id = build_id();
  header.configuration = to_text(configuration);
  header.dbc = builtin_dbc();
  header.calibration = builtin_calibration();
  return header;
}

RobotSetup BenchDrive::setup(const Configuration& configuration) {
  return make_setup(configuration, header(configuration), "built-in");
}

}  // namespace hindsight::tools
