// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_trace.h"

#include <cmath>
#include <limits>

namespace hindsight::tools {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

DriveCommand measured_speeds(const Sensed& sensed) {
  if (!sensed.wheels_fresh) return {kNan, kNan};
  return {sensed.vehicle.left_mps, sensed.vehicle.right_mps};
}

}  // namespace

void RunTrace::add(ReplayRun& run) {
  Robot& robot = run.robot();
  const TickInput& input = run.input();
  if (!began_) began_ = input.now;
  TickTrace tick;
  tick.time_s = to_seconds(input.now - *began_);
  tick.behaviour = robot.plan().behaviour;
  tick.stop = run.decision().reason;
  tick.sources = robot.sensed().sources;
  const PoseEstimate& pose = robot.localisation().estimate();
  tick.X_WB = pose.X_WB;
  tick.commanded = run.decision().command;
  tick.measured = measured_speeds(robot.sensed());
  tick.step_ms = tick.latency_ms = kNan;
  const SlipWatch& slip = robot.senses().slip();
  for (std::size_t wheel = 0; wheel < kWheelCount; ++wheel) {
    tick.slipping[wheel] = slip.slipping(static_cast<Wheel>(wheel));
    tick.loss[wheel] = slip.ground().known ? slip.ground().wheels[wheel] : WheelLoss{false, kNan, kNan, kNan};
  }
  if (!ticks.empty()) {
    add_timing(input.timing);
    distance_m += std::abs(pose.v_mps) * (tick.time_s - ticks.back().time_s);
  }
  for (std::size_t line = 0; line < active_.size(); ++line) {
    const bool active = robot.sensed().active[line] || robot.sensed().touched[line];
    if (active && !active_[line]) ++touches[line];
    active_[line] = active;
  }
  for (const Lesson& lesson : robot.learner().lessons()) {
    events.push_back({tick.time_s, input.index, lesson.event.cause, lesson.event.p_WP_m});
  }
  if (input.frame) ++frames;
  const RoadFollower* road = robot.sight().road();
  road_sought = road != nullptr;
  const bool followed = road_sought && road->estimate().status == RoadStatus::following;
  tick.road_confidence = followed ? road->estimate().confidence : kNan;
  if (robot.plan().reached && !reached_s) reached_s = tick.time_s;
  ticks.push_back(tick);
  add_spectra(robot.senses().slip().currents());
}

/// A tick's input tells how the tick before it went.
void RunTrace::add_timing(const LoopTiming& timing) {
  ticks.back().step_ms = 1e3 * to_seconds(timing.step_duration);
  ticks.back().latency_ms = 1e3 * to_seconds(timing.wake_latency);
  wake_latency.add(timing.wake_latency);
  step_duration.add(timing.step_duration);
  overruns = timing.overruns;
  recorder_dropped = timing.recorder_dropped;
}

void RunTrace::add_spectra(const SlipDetector& detector) {
  for (std::size_t wheel = 0; wheel < kWheelCount; ++wheel) {
    const CurrentSpectrum& spectrum = detector.spectrum(static_cast<Wheel>(wheel));
    SpectrumTrace& trace = spectra[wheel];
    const auto now = spectrum.relative_amplitudes();
    trace.bins = now.size();
    trace.hz_per_bin = spectrum.hz_per_bin();
    if (spectrum.full()) {
      trace.amplitudes.insert(trace.amplitudes.end(), now.begin(), now.end());
    } else {
      trace.amplitudes.insert(trace.amplitudes.end(), now.size(), std::numeric_limits<float>::quiet_NaN());
    }
  }
}

}  // namespace hindsight::tools
