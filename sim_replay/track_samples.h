// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "drivers/samples.h"
#include "sim_replay/track_csv.h"

namespace hindsight {

class TrackEncoder;

struct TrackSamples {
  std::vector<CanFrame> can;
  std::vector<LineEdge> edges;
  std::vector<GpsFix> fixes;
  std::vector<OperatorCommand> commands;
};

/// Turns the rows of a track into samples, remembering levels and goals to tell changes.
class TrackSampler {
 public:
  /// `encoder` must outlive it.
  explicit TrackSampler(TrackEncoder& encoder) : encoder_(encoder) {}
  /// The row's samples, valid until the next call.
  const TrackSamples& convert(const TrackRow& row, Time stamp);

 private:
  void add_edge(Line line, const TrackRow::Cell& level, Time stamp);
  void add_commands(const TrackRow& row, Time stamp);
  void add_command(CommandKind kind, double a, double b, Time stamp);

  TrackEncoder& encoder_;
  TrackSamples samples_;
  std::array<std::optional<bool>, kLineCount> levels_;
  std::optional<std::pair<double, double>> goal_m_;
  bool armed_ = false;
  std::int64_t command_sequence_ = 0;
};

}  // namespace hindsight
