// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/telemetry.h"

#include <algorithm>
#include <cmath>

#include "daemon/telemetry_messages.h"

namespace hindsight {
namespace {

/// Room for a path that winds through the whole of a large window.
constexpr std::size_t kLongestPath = 8192;
constexpr std::size_t kMostRollouts = 512;
constexpr std::uint64_t kActivityEveryTicks = 50;
constexpr std::uint64_t kHistogramEveryTicks = 50;

/// Larger standard deviation of the position: the root of the covariance's larger eigenvalue.
double position_sigma_m(const Eigen::Matrix3d& covariance) {
  const double mean = 0.5 * (covariance(0, 0) + covariance(1, 1));
  const double half_difference = 0.5 * (covariance(0, 0) - covariance(1, 1));
  return std::sqrt(mean + std::hypot(half_difference, covariance(0, 1)));
}

}  // namespace

Telemetry::Telemetry(const Configuration& configuration)
    : params_(configuration.telemetry),
      look_ahead_m_(configuration.road.look_ahead_m),
      messages_(std::make_unique<Messages>()) {
  plan_t& plan = messages_->plan;
  for (auto* path : {&plan.path_east_m, &plan.path_north_m}) path->reserve(kLongestPath);
  for (auto* rollouts : {&plan.end_east_m, &plan.end_north_m, &plan.score}) rollouts->reserve(kMostRollouts);
  if (configuration.motion.enabled) {
    activity_map_t& activity = messages_->activity;
    messages_->tracks.tracks.reserve(number<std::size_t>(configuration.motion.tracker.max_tracks));
    for (auto* list : {&activity.column, &activity.row}) list->reserve(kMostActivityCells);
    for (auto* list : {&activity.speed_m, &activity.direction_rad, &activity.share}) list->reserve(kMostActivityCells);
    activity.total.reserve(kMostActivityCells);
  }
  road_t& road = messages_->road;
  for (auto* values : {&road.row_px, &road.left_px, &road.right_px, &road.ahead_m, &road.left_m, &road.right_m})
    values->reserve(kMostRoadRows);
  messages_->mixture.components.reserve(number<std::size_t>(configuration.mixture.max_components));
  messages_->mixture.color_space = configuration.mixture.color_space;
}

Telemetry::~Telemetry() = default;

void Telemetry::publish(const TickReport& tick, Outbox& outbox) {
  publish_state(tick, outbox);
  publish_pose(tick, outbox);
  if (tick.new_frame) publish_perception(tick, outbox);
  for (const Lesson& lesson : tick.learner.lessons()) publish_training(tick, lesson, outbox);
  if (tick.learner.mixture().version() != mixture_version_) publish_mixture(tick, outbox);
  if (tick.input.index % number<std::uint64_t>(params_.grid_every_ticks) == 0) publish_grid(tick, outbox);
  if (tick.goal_W || tick.mode == Mode::road) publish_plan(tick, outbox);
  publish_road(tick, outbox);
  publish_slip(tick, outbox);
  if (tick.motion != nullptr && tick.new_frame) publish_tracks(tick, outbox);
  if (tick.motion != nullptr && tick.input.index % kActivityEveryTicks == 0) publish_activity(tick, outbox);
  publish_timing(tick, outbox);
}

void Telemetry::publish_state(const TickReport& tick, Outbox& outbox) {
  state_t& m = messages_->state;
  const VehicleSignals& vehicle = tick.sensed.vehicle;
  m.utime = tick.input.utime_us;
  m.tick = number<std::int64_t>(tick.input.index);
  m.mode = number<std::int8_t>(tick.mode);
  m.behaviour = number<std::int8_t>(tick.plan.behaviour);
  m.stop_reason = number<std::int8_t>(tick.decision.reason);
  m.armed = number<std::int8_t>(tick.armed);
  m.position_m[0] = tick.pose.X_WB.x_m;
  m.position_m[1] = tick.pose.X_WB.y_m;
  m.heading_rad = tick.pose.X_WB.heading_rad;
  m.position_sigma_m = position_sigma_m(tick.pose.covariance);
  m.speed_mps = tick.pose.v_mps;
  m.yaw_rate_radps = tick.pose.yaw_rate_radps;
  m.has_goal = number<std::int8_t>(tick.goal_W.has_value());
  m.goal_m[0] = tick.goal_W ? tick.goal_W->x_m : 0.0;
  m.goal_m[1] = tick.goal_W ? tick.goal_W->y_m : 0.0;
  m.cost_to_goal = tick.plan.cost_to_goal;
  m.command_mps[0] = number<float>(tick.decision.command.left_mps);
  m.command_mps[1] = number<float>(tick.decision.command.right_mps);
  m.reflex_mps[0] = tick.input.reflex.left_mps;
  m.reflex_mps[1] = tick.input.reflex.right_mps;
  m.reflex_reason = number<std::int8_t>(tick.input.reflex.stop_reason);
  for (std::size_t i = 0; i < kLineCount; ++i) m.line_active[i] = number<std::int8_t>(tick.sensed.active[i]);
  m.ir_range_m[0] = number<float>(vehicle.ir_left_m);
  m.ir_range_m[1] = number<float>(vehicle.ir_right_m);
  m.battery_v = number<float>(vehicle.battery_v);
  m.slipping = number<std::int8_t>(tick.sensed.slipping);
  for (std::size_t i = 0; i < kSourceCount; ++i) {
    m.source_state[i] = number<std::int8_t>(tick.sensed.sources[i]);
    m.source_dropped[i] = number<std::int32_t>(tick.sensed.dropped[i]);
  }
  m.bad_can_frames = number<std::int32_t>(vehicle.bus.bad_checksums + vehicle.bus.bad_counters);
  outbox.add("HINDSIGHT_STATE", m.utime, m);
}

void Telemetry::publish_pose(const TickReport& tick, Outbox& outbox) {
  bot_core::pose_t& m = messages_->pose;
  m.utime = tick.input.utime_us;
  m.pos[0] = tick.pose.X_WB.x_m;
  m.pos[1] = tick.pose.X_WB.y_m;
  m.vel[0] = tick.pose.v_mps;
  m.orientation[0] = std::cos(0.5 * tick.pose.X_WB.heading_rad);
  m.orientation[3] = std::sin(0.5 * tick.pose.X_WB.heading_rad);
  m.rotation_rate[2] = tick.pose.yaw_rate_radps;
  outbox.add("POSE", m.utime, m);
}

void Telemetry::publish_grid(const TickReport& tick, Outbox& outbox) {
  grid_t& m = messages_->grid;
  const GridWindow& window = tick.grid.window();
  const Cell centre = window.cell_at(tick.pose.X_WB.x_m, tick.pose.X_WB.y_m);
  const int cells = params_.grid_cells;
  m.utime = tick.input.utime_us;
  m.tick = number<std::int64_t>(tick.input.index);
  m.origin[0] = centre.i - cells / 2;
  m.origin[1] = centre.j - cells / 2;
  m.width = number<std::int16_t>(cells);
  m.height = number<std::int16_t>(cells);
  m.resolution_m = number<float>(window.resolution_m);
  m.size = cells * cells;
  m.cost.resize(number<std::size_t>(m.size));
  auto cost = m.cost.begin();
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) *cost++ = number<std::uint8_t>(tick.grid.cost({m.origin[0] + i, m.origin[1] + j}));
  }
  outbox.add("HINDSIGHT_GRID", m.utime, m);
}

void Telemetry::publish_plan(const TickReport& tick, Outbox& outbox) {
  plan_t& m = messages_->plan;
  const auto& path = tick.plan.path_W;
  const auto& rollouts = tick.plan.rollouts;
  m.utime = tick.input.utime_us;
  m.tick = number<std::int64_t>(tick.input.index);
  m.path_size = number<std::int16_t>(path.size());
  m.path_east_m.resize(path.size());
  m.path_north_m.resize(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    m.path_east_m[i] = number<float>(path[i].x_m);
    m.path_north_m[i] = number<float>(path[i].y_m);
  }
  m.rollouts = number<std::int16_t>(rollouts.size());
  m.end_east_m.resize(rollouts.size());
  m.end_north_m.resize(rollouts.size());
  m.score.resize(rollouts.size());
  for (std::size_t i = 0; i < rollouts.size(); ++i) {
    m.end_east_m[i] = number<float>(rollouts[i].end_W.x_m);
    m.end_north_m[i] = number<float>(rollouts[i].end_W.y_m);
    m.score[i] = number<float>(rollouts[i].score_m);
  }
  m.chosen = number<std::int16_t>(tick.plan.chosen);
  m.expansions = tick.plan.expansions;
  outbox.add("HINDSIGHT_PLAN", m.utime, m);
}

void Telemetry::publish_slip(const TickReport& tick, Outbox& outbox) {
  slip_t& m = messages_->slip;
  m.utime = tick.input.utime_us;
  m.tick = number<std::int64_t>(tick.input.index);
  const SlipDetector& currents = tick.slip.currents();
  const GroundSlipReport& ground = tick.slip.ground();
  const auto left = currents.spectrum(Wheel::left).relative_amplitudes();
  const auto right = currents.spectrum(Wheel::right).relative_amplitudes();
  m.slipping = number<std::int8_t>(tick.slip.slipping());
  m.ground_known = number<std::int8_t>(ground.known);
  m.hz_per_bin = number<float>(currents.spectrum(Wheel::left).hz_per_bin());
  for (std::size_t wheel = 0; wheel < kWheelCount; ++wheel) {
    m.wheel_mps[wheel] = number<float>(ground.wheels[wheel].wheel_mps);
    m.ground_mps[wheel] = number<float>(ground.wheels[wheel].ground_mps);
    m.lost_way_m[wheel] = number<float>(ground.wheels[wheel].lost_way_m);
    m.peak[wheel] = number<float>(currents.report().wheels[wheel].component);
  }
  m.bins = number<std::int16_t>(left.size());
  m.left.assign(left.begin(), left.end());
  m.right.assign(right.begin(), right.end());
  outbox.add("HINDSIGHT_SLIP", m.utime, m);
}

void Telemetry::publish_timing(const TickReport& tick, Outbox& outbox) {
  timing_t& m = messages_->timing;
  m.utime = tick.input.utime_us;
  m.tick = number<std::int64_t>(tick.input.index);
  m.wake_latency_ns = tick.input.timing.wake_latency.count();
  m.step_duration_ns = tick.input.timing.step_duration.count();
  m.overruns = number<std::int32_t>(tick.input.timing.overruns);
  m.recorder_dropped = number<std::int32_t>(tick.input.timing.recorder_dropped);
  outbox.add("HINDSIGHT_TIMING", m.utime, m);
  if (tick.input.index == 0) return;  // there was no tick before
  wake_latency_.add(tick.input.timing.wake_latency);
  step_duration_.add(tick.input.timing.step_duration);
  if (tick.input.index % kHistogramEveryTicks == 0) publish_histogram(tick, outbox);
}

void Telemetry::publish_histogram(const TickReport& tick, Outbox& outbox) {
  timing_histogram_t& m = messages_->histogram;
  m.utime = tick.input.utime_us;
  m.tick = number<std::int64_t>(tick.input.index);
  std::ranges::copy(wake_latency_.counts(), m.wake_latency);
  std::ranges::copy(step_duration_.counts(), m.step_duration);
  outbox.add("HINDSIGHT_TIMING_HISTOGRAM", m.utime, m);
}

}  // namespace hindsight
