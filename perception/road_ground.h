// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The road on flat ground.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "perception/camera_model.h"
#include "perception/pose.h"
#include "perception/road_estimate.h"

namespace hindsight {

/// The road across the vehicle's way, in B; left_B.y_m > right_B.y_m.
struct RoadSection {
  Point2 left_B;
  Point2 right_B;

  Point2 middle_B() const { return {0.5 * (left_B.x_m + right_B.x_m), 0.5 * (left_B.y_m + right_B.y_m)}; }
};

struct RoadOnGround {
  int count = 0;
  std::array<RoadSection, kMostRoadRows> section{};

  /// From near to far; none where no road is followed.
  std::span<const RoadSection> sections() const {
    return std::span(section).first(static_cast<std::size_t>(count));
  }
};

/// Rows whose ground is farther than max_range_m are left out. The vehicle's pitch is taken out: rows are
/// moved by as much as the horizon lies off where the mounting has it.
RoadOnGround road_on_ground(const RoadEstimate& road, const CameraModel& camera, double max_range_m);

/// Where to drive: the middle of the road `ahead_m` from B's origin, or of its farthest section if it is seen
/// less far; empty where no road is.
std::optional<Point2> point_ahead_B(const RoadOnGround& road, double ahead_m);

/// Of the arc from B's origin, straight ahead at first, through a point (pure pursuit) [1/m]; left positive.
double curvature_to_per_m(const Point2& p_BP_m);

}  // namespace hindsight
