// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What the road follower says of the road ahead.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace hindsight {

/// Numbers are published and logged: append, never renumber.
enum class RoadStatus : std::uint8_t {
  short_history = 0,  ///< less has been seen than RoadParams::min_history_s
  no_horizon = 1,     ///< no horizon, or no ground below it, in view: how far things are cannot be told
  no_road = 2,        ///< nothing stands out as a road here
  following = 3
};

/// The road in one row of the picture; the centre of the first pixel is at 0. Edges may lie outside the
/// picture.
struct RoadRow {
  float row_px = 0.0F;
  float left_px = 0.0F;
  float right_px = 0.0F;
};

constexpr int kMostRoadRows = 33;

struct RoadEstimate {
  RoadStatus status = RoadStatus::short_history;
  double confidence = 0.0;      ///< 0: beside the road it looks as on it, 1: nothing alike
  double horizon_row_px = 0.0;  ///< in the middle of the picture; NaN: not known
  int count = 0;                ///< of rows; 0 unless following
  std::array<RoadRow, kMostRoadRows> row{};

  /// Where the road is, from near to far. The polygon goes up the left edges and down the right ones.
  std::span<const RoadRow> rows() const { return std::span(row).first(static_cast<std::size_t>(count)); }
};

}  // namespace hindsight
