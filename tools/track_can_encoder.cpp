// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/track_can_encoder.h"

#include <utility>

#include "drivers/dbc.h"

namespace hindsight::tools {

TrackCanEncoder::TrackCanEncoder(std::string dbc_text, const std::string& dbc_name, const CanRolesParams& roles)
    : text_(std::move(dbc_text)), codec_(parse_dbc(text_, dbc_name), roles) {}

void TrackCanEncoder::encode(const TrackRow& row, Time stamp, std::vector<CanFrame>& frames) {
  const auto take = [](const TrackRow::Cell& cell, double& value) {
    if (cell) value = *cell;
    return cell.has_value();
  };
  // The group's signals share a message, so one that is absent keeps its last value.
  const bool left = take(row.left_mps, signals_.left_mps);
  if (take(row.right_mps, signals_.right_mps) || left) codec_.encode(SignalGroup::wheels, signals_, stamp, frames);
  const bool left_current = take(row.left_a, signals_.left_a);
  if (take(row.right_a, signals_.right_a) || left_current) codec_.encode(SignalGroup::currents, signals_, stamp, frames);
  const bool left_range = take(row.ir_left_m, signals_.ir_left_m);
  if (take(row.ir_right_m, signals_.ir_right_m) || left_range) codec_.encode(SignalGroup::ir_ranges, signals_, stamp, frames);
  if (take(row.yaw_rate_radps, signals_.yaw_rate_radps)) codec_.encode(SignalGroup::imu, signals_, stamp, frames);
}

}  // namespace hindsight::tools
