// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What the camera made of the world, as messages.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "daemon/telemetry.h"
#include "daemon/telemetry_messages.h"

namespace hindsight {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

float horizon_at(const GroundPlane& ground, std::size_t column) {
  const float row = ground.horizon_row_px()[column];
  const bool in_view = row > -0.5F && row < static_cast<float>(ground.height_px()) - 0.5F;
  return in_view ? row : kNan;
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
  for (std::size_t i = 0; i < m.components.size(); ++i)
    copy_component(mixture.components()[i], m.components[i]);
  outbox.add("HINDSIGHT_MIXTURE", m.utime, m);
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

/// Only when something new is in it. Of more cells than fit, those that have been active for the longest
/// time.
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

}  // namespace hindsight
