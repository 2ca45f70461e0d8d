// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/slip_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "daemon/run_setup.h"
#include "perception/optical_flow.h"
#include "sim_replay/world/random.h"
#include "tools/sim_feed.h"
#include "tools/sim_run.h"

namespace hindsight::tools {
namespace {

constexpr std::uint64_t kFeedStream = 78;

/// How B moved: what would be without error.
StepError true_step(const BodyPose& X_WThen, const BodyPose& X_WNow) {
  const double forward_m = std::cos(X_WThen.heading_rad) * (X_WNow.x_m - X_WThen.x_m) +
                           std::sin(X_WThen.heading_rad) * (X_WNow.y_m - X_WThen.y_m);
  return {true, forward_m, std::remainder(X_WNow.heading_rad - X_WThen.heading_rad, 2.0 * std::numbers::pi)};
}

}  // namespace

void look_at_ground(const Configuration& configuration, const World& world, std::uint64_t seed,
                    std::span<const SlipSpan> when, SlipTrace& trace) {
  const CameraModel camera = make_setup(configuration, sim_materials(configuration, {}), "camera").camera;
  Renderer renderer(world, render_camera(camera), seed);
  OpticalFlow flow(configuration.flow, camera.width_px, camera.height_px);
  GroundOdometry odometry(configuration.ground_odometry, camera);
  bool looked = false;
  for (std::size_t i = 1; i < trace.ticks.size(); ++i) {
    const SlipTrace::Tick &before = trace.ticks[i - 1], &tick = trace.ticks[i];
    const bool looks = std::any_of(when.begin(), when.end(), [&](const SlipSpan& span) {
      return tick.now >= span.begin && tick.now <= span.end;
    });
    if (!looks) {
      looked = false;
      continue;
    }
    const RenderedFrame& frame = renderer.render(tick.X_WB, before.X_WB, to_seconds(tick.now - before.now),
                                                 to_seconds(tick.now), false);
    if (!looked) flow.reset();
    const auto vectors = flow.update(frame.bgr);
    if (looked) trace.steps.push_back({before.now, tick.now, odometry.measure(vectors)});
    looked = true;
  }
}

std::vector<StepError> step_errors(const SlipTrace& trace) {
  std::vector<StepError> errors;
  auto step = trace.steps.begin();
  for (std::size_t i = 1; i < trace.ticks.size() && step != trace.steps.end(); ++i) {
    if (trace.ticks[i].now != step->to) continue;
    const StepError truth = true_step(trace.ticks[i - 1].X_WB, trace.ticks[i].X_WB);
    errors.push_back({step->motion.valid, step->motion.forward_m - truth.forward_m,
                      step->motion.turn_rad - truth.turn_rad});
    ++step;
  }
  return errors;
}

void feed_steps(std::span<const StepError> errors, std::uint64_t seed, SlipTrace& trace) {
  if (errors.empty()) return;
  auto k =
      static_cast<std::size_t>(Random(seed, kFeedStream).uniform(0.0, static_cast<double>(errors.size())));
  for (std::size_t i = 1; i < trace.ticks.size(); ++i, ++k) {
    const SlipTrace::Tick &before = trace.ticks[i - 1], &tick = trace.ticks[i];
    const StepError& error = errors[k % errors.size()];
    const StepError truth = true_step(before.X_WB, tick.X_WB);
    OdometryMotion motion;
    motion.valid = error.valid;
    motion.forward_m = truth.forward_m + error.forward_m;
    motion.turn_rad = truth.turn_rad + error.turn_rad;
    trace.steps.push_back({before.now, tick.now, motion});
  }
}

}  // namespace hindsight::tools
