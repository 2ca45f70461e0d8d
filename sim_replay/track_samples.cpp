// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/track_samples.h"

#include "sim_replay/importer.h"

namespace hindsight {

const TrackSamples& TrackSampler::convert(const TrackRow& row, Time stamp) {
  samples_.can.clear();
  samples_.edges.clear();
  samples_.fixes.clear();
  samples_.commands.clear();
  encoder_.encode(row, stamp, samples_.can);
  add_edge(Line::bumper_left, row.bumper_left, stamp);
  add_edge(Line::bumper_right, row.bumper_right, stamp);
  add_edge(Line::estop, row.estop, stamp);
  if (row.latitude_deg) samples_.fixes.push_back({stamp, *row.latitude_deg, *row.longitude_deg, 0.0, 0.0});
  add_commands(row, stamp);
  return samples_;
}

void TrackSampler::add_edge(Line line, const TrackRow::Cell& level, Time stamp) {
  if (!level) return;
  const bool active = *level != 0.0;
  auto& before = levels_[static_cast<std::size_t>(line)];
  if (before != active) samples_.edges.push_back({stamp, line, active});
  before = active;
}

void TrackSampler::add_commands(const TrackRow& row, Time stamp) {
  const bool arm = row.arm ? *row.arm != 0.0 : armed_;
  if (arm != armed_) add_command(arm ? CommandKind::arm : CommandKind::disarm, 0.0, 0.0, stamp);
  armed_ = arm;
  if (!row.goal_east_m) return;
  const std::pair goal_m{*row.goal_east_m, *row.goal_north_m};
  if (goal_m_ != goal_m) add_command(CommandKind::go_to_local, goal_m.first, goal_m.second, stamp);
  goal_m_ = goal_m;
}

void TrackSampler::add_command(CommandKind kind, double a, double b, Time stamp) {
  samples_.commands.push_back({stamp, kind, a, b, ++command_sequence_});
}

}  // namespace hindsight
