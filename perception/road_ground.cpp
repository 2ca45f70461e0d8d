// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_ground.h"

#include <cmath>

#include "perception/ground_plane.h"
#include "perception/road_horizon.h"

namespace hindsight {
namespace {

double length_m(const Point2& p) { return std::hypot(p.x_m, p.y_m); }

}  // namespace

RoadOnGround road_on_ground(const RoadEstimate& road, const CameraModel& camera, double max_range_m) {
  RoadOnGround ground;
  const double pitch_px = horizon_row_px(camera) - road.horizon_row_px;
  if (!std::isfinite(pitch_px)) return ground;
  for (const RoadRow& row : road.rows()) {
    const double middle_px = 0.5 * static_cast<double>(row.left_px + row.right_px);
    const auto middle_B = ground_point(camera, {middle_px, static_cast<double>(row.row_px) + pitch_px});
    if (!middle_B || length_m(*middle_B) > max_range_m) continue;
    const Eigen::Vector3d p_C =
        camera.R_BC.transpose() * (Eigen::Vector3d(middle_B->x_m, middle_B->y_m, 0.0) - camera.p_BC_m);
    const double half_m = 0.5 * static_cast<double>(row.right_px - row.left_px) * p_C.z() / camera.fx_px;
    ground.section[static_cast<std::size_t>(ground.count++)] = {{middle_B->x_m, middle_B->y_m + half_m},
                                                                {middle_B->x_m, middle_B->y_m - half_m}};
  }
  return ground;
}

std::optional<Point2> point_ahead_B(const RoadOnGround& road, double ahead_m) {
  std::optional<Point2> before;
  for (const RoadSection& section : road.sections()) {
    const Point2 here = section.middle_B();
    if (length_m(here) >= ahead_m) {
      if (!before) return here;
      const double share = (ahead_m - length_m(*before)) / (length_m(here) - length_m(*before));
      return Point2{before->x_m + share * (here.x_m - before->x_m),
                    before->y_m + share * (here.y_m - before->y_m)};
    }
    before = here;
  }
  return before;
}

double curvature_to_per_m(const Point2& p_BP_m) {
  const double squared_m2 = p_BP_m.x_m * p_BP_m.x_m + p_BP_m.y_m * p_BP_m.y_m;
  return squared_m2 > 0.0 ? 2.0 * p_BP_m.y_m / squared_m2 : 0.0;
}

}  // namespace hindsight
