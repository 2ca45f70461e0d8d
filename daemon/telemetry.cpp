// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/telemetry.h"

#include <bot_core/pose_t.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <hindsight/activity_map_t.hpp>
#include <hindsight/grid_t.hpp>
#include <hindsight/mixture_t.hpp>
#include <hindsight/perception_t.hpp>
#include <hindsight/plan_t.hpp>
#include <hindsight/road_t.hpp>
#include <hindsight/slip_t.hpp>
#include <hindsight/state_t.hpp>
#include <hindsight/timing_t.hpp>
#include <hindsight/tracks_t.hpp>
#include <hindsight/training_t.hpp>
#include <limits>

namespace hindsight {
namespace {

/// Room for a path that winds through the whole of a large window.
constexpr std::size_t kLongestPath = 8192;
constexpr std::size_t kMostRollouts = 512;
constexpr std::uint64_t kActivityEveryTicks = 50;
constexpr std::size_t kMostActivityCells = 2000;  ///< that fit into a message
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

template <typename To, typename From>
To number(From value) {
  return static_cast<To>(value);
}

/// Larger standard deviation of the position: the root of the covariance's larger eigenvalue.
double position_sigma_m(const Eigen::Matrix3d& covariance) {
  const double mean = 0.5 * (covariance(0, 0) + covariance(1, 1));
  const double half_difference = 0.5 * (covariance(0, 0) - covariance(1, 1));
  return std::sqrt(mean + std::hypot(half_difference, covariance(0, 1)));
}

float horizon_at(const GroundPlane& ground, std::size_t column) {
  const float row = ground.horizon_row_px()[column];
  const bool in_view = row > -0.5F && row < static_cast<float>(ground.height_px()) - 0.5F;
  return in_view ? row : std::numeric_limits<float>::quiet_NaN();
}

void copy_component(const MixtureComponent& from, mixture_component_t& to) {
  for (int i = 0; i < 3; ++i) {
    to.mean[i] = from.mean(i);
    to.votes[i] = from.votes[number<std::size_t>(i)];
    for (int j = 0; j < 3; ++j) to.covariance[i][j] = from.covariance(i, j);
  }
  to.weight = from.weight_px;
  to.label = number<std::int8_t>(from.label);
}

}  // namespace

/// Kept from tick to tick, so that their vectors keep their memory.
struct Telemetry::Messages {
  state_t state{};
  bot_core::pose_t pose{};
  perception_t perception{};
  training_t training{};
  mixture_t mixture{};
  grid_t grid{};
  plan_t plan{};
  road_t road{};
  slip_t slip{};
  timing_t timing{};
  tracks_t tracks{};
  activity_map_t activity{};
};

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

void Telemetry::publish_perception(const TickReport& tick, Outbox& outbox) {
  perception_t& m = messages_->perception;
  const FlowGrid& grid = tick.sight.history().newest();
  m.utime = tick.input.utime_us;
  m.tick = number<std::int64_t>(tick.input.index);
  m.features = number<std::int32_t>(tick.sight.flow().features().size());
  m.vectors = number<std::int32_t>(tick.sight.vectors().size());
  m.history_frames = tick.sight.history().size();
  m.columns = number<std::int16_t>(grid.columns);
  m.rows = number<std::int16_t>(grid.rows);
  m.cells = number<std::int16_t>(grid.cells.size());
  m.flow_dx_px.resize(grid.cells.size());
  m.flow_dy_px.resize(grid.cells.size());
  m.support.resize(grid.cells.size());
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    m.flow_dx_px[i] = grid.cells[i].dx_px;
    m.flow_dy_px[i] = grid.cells[i].dy_px;
    m.support[i] = number<std::int16_t>(grid.cells[i].count);
  }
  const auto counts = tick.sight.label_counts();
  for (std::size_t i = 0; i < counts.size(); ++i) m.label_px[i] = counts[i];
  const GroundPlane& ground = tick.sight.ground();
  m.horizon_px[0] = horizon_at(ground, 0);
  m.horizon_px[1] = horizon_at(ground, ground.horizon_row_px().size() - 1);
  outbox.add("HINDSIGHT_PERCEPTION", m.utime, m);
}

void Telemetry::publish_training(const TickReport& tick, const Lesson& lesson, Outbox& outbox) {
  training_t& m = messages_->training;
  m.utime = tick.input.utime_us;
  m.tick = number<std::int64_t>(tick.input.index);
  m.cause = number<std::int8_t>(lesson.event.cause);
  m.label = number<std::int8_t>(lesson.event.label);
  m.in_view = number<std::int8_t>(lesson.event.in_view);
  m.place_m[0] = lesson.event.p_WP_m.x_m;
  m.place_m[1] = lesson.event.p_WP_m.y_m;
  m.from_frames_back = lesson.event.frames_back;
  m.from_px[0] = lesson.event.patch_px.x_px;
  m.from_px[1] = lesson.event.patch_px.y_px;
  m.from_px[2] = lesson.event.patch_px.width_px;
  m.from_px[3] = lesson.event.patch_px.height_px;
  m.to_frames_back = lesson.traced.frames_back;
  m.to_px[0] = lesson.traced.there_px.x_px;
  m.to_px[1] = lesson.traced.there_px.y_px;
  m.to_px[2] = lesson.traced.there_px.width_px;
  m.to_px[3] = lesson.traced.there_px.height_px;
  m.points = lesson.traced.points;
  m.pixels = lesson.report.pixels;
  m.new_components = lesson.report.new_components;
  m.component = lesson.report.updated_component;
  outbox.add("HINDSIGHT_TRAINING", m.utime, m);
}

void Telemetry::publish_mixture(const TickReport& tick, Outbox& outbox) {
  mixture_t& m = messages_->mixture;
  const TerrainMixture& mixture = tick.learner.mixture();
  mixture_version_ = mixture.version();
  m.utime = tick.input.utime_us;
  m.tick = number<std::int64_t>(tick.input.index);
  m.size = number<std::int16_t>(mixture.components().size());
  m.components.resize(mixture.components().size());
  for (std::size_t i = 0; i < m.components.size(); ++i) copy_component(mixture.components()[i], m.components[i]);
  outbox.add("HINDSIGHT_MIXTURE", m.utime, m);
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

void Telemetry::publish_road(const TickReport& tick, Outbox& outbox) {
  const RoadFollower* follower = tick.sight.road();
  if (!tick.new_frame || follower == nullptr) return;
  road_t& m = messages_->road;
  const RoadEstimate& road = follower->estimate();
  const RoadOnGround& ground = tick.sight.road_on_ground();
  const std::optional<Point2> ahead_B = point_ahead_B(ground, look_ahead_m_);
  m.utime = tick.input.utime_us;
  m.tick = number<std::int64_t>(tick.input.index);
  m.status = number<std::int8_t>(road.status);
  m.confidence = number<float>(road.confidence);
  m.horizon_px = number<float>(road.horizon_row_px);
  m.bearing_rad = ahead_B ? number<float>(std::atan2(ahead_B->y_m, ahead_B->x_m)) : kNan;
  m.curvature_per_m = ahead_B ? number<float>(curvature_to_per_m(*ahead_B)) : kNan;
  m.rows = number<std::int16_t>(road.count);
  for (auto* values : {&m.row_px, &m.left_px, &m.right_px}) values->resize(road.rows().size());
  for (std::size_t i = 0; i < road.rows().size(); ++i) {
    m.row_px[i] = road.rows()[i].row_px;
    m.left_px[i] = road.rows()[i].left_px;
    m.right_px[i] = road.rows()[i].right_px;
  }
  m.sections = number<std::int16_t>(ground.count);
  for (auto* values : {&m.ahead_m, &m.left_m, &m.right_m}) values->resize(ground.sections().size());
  for (std::size_t i = 0; i < ground.sections().size(); ++i) {
    const RoadSection& section = ground.sections()[i];
    m.ahead_m[i] = number<float>(section.middle_B().x_m);
    m.left_m[i] = number<float>(section.left_B.y_m);
    m.right_m[i] = number<float>(section.right_B.y_m);
  }
  outbox.add("HINDSIGHT_ROAD", m.utime, m);
}

void Telemetry::publish_slip(const TickReport& tick, Outbox& outbox) {
  slip_t& m = messages_->slip;
  m.utime = tick.input.utime_us;
  m.tick = number<std::int64_t>(tick.input.index);
  const SlipReport& report = tick.slip.report();
  const auto left = tick.slip.spectrum(Wheel::left).relative_amplitudes();
  const auto right = tick.slip.spectrum(Wheel::right).relative_amplitudes();
  m.slipping = number<std::int8_t>(report.slipping);
  m.hz_per_bin = number<float>(tick.slip.spectrum(Wheel::left).hz_per_bin());
  for (std::size_t wheel = 0; wheel < kWheelCount; ++wheel) m.peak[wheel] = number<float>(report.wheels[wheel].component);
  m.bins = number<std::int16_t>(left.size());
  m.left.assign(left.begin(), left.end());
  m.right.assign(right.begin(), right.end());
  outbox.add("HINDSIGHT_SLIP", m.utime, m);
}

void Telemetry::publish_tracks(const TickReport& tick, Outbox& outbox) {
  tracks_t& m = messages_->tracks;
  const MotionReport& report = tick.motion->report();
  m.utime = tick.input.utime_us;
  m.tick = number<std::int64_t>(tick.input.index);
  m.gap_frames = number<std::int8_t>(report.gap_frames);
  m.noise_px = number<float>(report.compared.noise_px);
  m.moving_features = number<std::int32_t>(report.features.size());
  m.parallax_features = number<std::int32_t>(report.parallax_features);
  m.size = number<std::int16_t>(report.tracks.size());
  m.tracks.resize(report.tracks.size());
  for (std::size_t i = 0; i < m.tracks.size(); ++i) {
    const Track& from = report.tracks[i];
    track_t& to = m.tracks[i];
    to.id = from.id;
    to.at_px[0] = from.at_px.x_px, to.at_px[1] = from.at_px.y_px;
    to.v_px[0] = from.v_px.x_px, to.v_px[1] = from.v_px.y_px;
    to.half_size_px[0] = from.half_size_px.x_px, to.half_size_px[1] = from.half_size_px.y_px;
    to.age_frames = from.age_frames, to.unseen_frames = number<std::int16_t>(from.unseen_frames);
    const GroundMotion& ground = tick.motion->on_ground()[i];
    to.position_m[0] = ground.p_W_m.x(), to.position_m[1] = ground.p_W_m.y();
  }
  outbox.add("HINDSIGHT_TRACKS", m.utime, m);
}

/// Only when something new is in it. Of more cells than fit, those that have been active for the longest time.
void Telemetry::publish_activity(const TickReport& tick, Outbox& outbox) {
  const ActivityMap& map = tick.motion->map();
  if (map.total() == activity_total_) return;
  activity_total_ = map.total();
  activity_map_t& m = messages_->activity;
  m.utime = tick.input.utime_us;
  m.tick = number<std::int64_t>(tick.input.index);
  m.cell_m = number<float>(map.cell());
  m.size = number<std::int16_t>(std::min(kMostActivityCells, map.active().size()));
  for (auto* list : {&m.column, &m.row}) list->resize(number<std::size_t>(m.size));
  for (auto* list : {&m.speed_m, &m.direction_rad, &m.share}) list->resize(number<std::size_t>(m.size));
  m.total.resize(number<std::size_t>(m.size));
  for (std::size_t i = 0; i < m.total.size(); ++i) {
    const ActivityMap::ActiveCell& cell = map.active()[i];
    std::array<ActivityMode, 1> mode{};
    find_modes(map, i, mode);
    m.column[i] = number<std::int16_t>(cell.column - map.cells() / 2);
    m.row[i] = number<std::int16_t>(cell.row - map.cells() / 2);
    m.total[i] = number<std::int32_t>(cell.total);
    m.speed_m[i] = number<float>(mode[0].speed);
    m.direction_rad[i] = number<float>(mode[0].direction_rad);
    m.share[i] = number<float>(mode[0].share);
  }
  outbox.add("HINDSIGHT_ACTIVITY", m.utime, m);
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
}

}  // namespace hindsight
