// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The evidence grid as a map: north up, east right.
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <span>
#include <vector>

#include "config/vehicle_params.h"
#include "perception/activity_map.h"
#include "perception/evidence_grid.h"
#include "tools/report_trace.h"

namespace hindsight::tools {

struct MapScene {
  const EvidenceGrid* grid = nullptr;     ///< never null
  const ActivityMap* activity = nullptr;  ///< where things move, in W; null: not looked for
  std::vector<Point2> track_W;            ///< where the robot was
  std::vector<Point2> path_W;             ///< where it means to go
  std::optional<Point2> goal_W;
  std::vector<EventTrace> events;
  Pose2 X_WB;
  VehicleParams vehicle;
};

/// What is to be drawn of a run after the tick that it has just stepped through.
MapScene scene_of(ReplayRun& run, const RunTrace& trace);

/// From W to pixels: x east is to the right, y north is up.
class MapView {
 public:
  MapView(Point2 south_west_W, Point2 north_east_W, double px_per_m);

  cv::Point2d at(Point2 p_W) const;
  cv::Size size() const;
  double px_per_m() const { return px_per_m_; }

 private:
  Point2 south_west_W_;
  Point2 north_east_W_;
  double px_per_m_;
};

/// Shows all that is known and all that was driven, with the longer side most_px long; a goal far outside is
/// left out.
MapView fit_map(const MapScene& scene, int most_px);
cv::Mat draw_map(const MapScene& scene, const MapView& view);

}  // namespace hindsight::tools
