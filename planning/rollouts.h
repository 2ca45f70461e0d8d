// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Local control (thesis 5.2.4): short trajectories that the differential drive can follow, each scored with
// its own cost and the cost of the best global path from its end.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "config/params.h"
#include "config/vehicle_params.h"
#include "perception/evidence_grid_geometry.h"
#include "perception/pose.h"
#include "planning/cost_map.h"
#include "planning/drive_command.h"
#include "planning/dstar.h"

namespace hindsight {

struct RolloutParams {
  double horizon_s = 2.0;
  double cruise_mps = 1.0;
  double slow_mps = 0.4;
  int careful_cost = 6;   ///< a roll-out over such cells (beside an obstacle, or rough) is driven slowly
  double turn_mps = 0.3;  ///< wheel speed of a turn on the spot
  double max_curvature_per_m = 2.5;
  int curvatures = 15;
  double own_cost_weight = 0.5;  ///< below 1: of equally good ways the one that gets on
  double progress_weight = 0.3;  ///< gain of each metre driven, so that grazing a margin does not stop it
  double heading_weight_m_per_rad =
      0.3;                        ///< for ending up turned away from the path that leads on from there
  double change_weight_s = 0.05;  ///< for changing the wheels' speeds [m per m/s]

  void visit(auto&& param) {
    param("horizon_s", horizon_s, Range{0.2, 10.0}, "length of a roll-out [s]");
    param("cruise_mps", cruise_mps, Range{0.05, 5.0}, "fastest that the robot drives by itself [m/s]");
    param("slow_mps", slow_mps, Range{0.05, 5.0},
          "fastest over careful_cost, and when a range sensor answers [m/s]");
    param("careful_cost", careful_cost, Range{2, 61}, "traversal cost from which on the robot drives slowly");
    param("turn_mps", turn_mps, Range{0.05, 2.0}, "speed of the wheels in a turn on the spot [m/s]");
    param("max_curvature_per_m", max_curvature_per_m, Range{0.1, 10.0}, "sharpest arc [1/m]");
    param("curvatures", curvatures, Range{3, 41}, "number of arcs at each speed");
    param("own_cost_weight", own_cost_weight, Range{0.0, 1.0},
          "weight of a roll-out's own cost against the path's");
    param("progress_weight", progress_weight, Range{0.0, 1.0}, "gain of each metre driven [m/m]");
    param("heading_weight_m_per_rad", heading_weight_m_per_rad, Range{0.0, 10.0},
          "cost of ending up turned away from the path [m/rad]");
    param("change_weight_s", change_weight_s, Range{0.0, 10.0},
          "cost of changing the wheels' speeds [m per m/s]");
  }
};

constexpr int kRolloutSamples = 16;

/// One trajectory from the present pose. Costs are in metres of free ground.
struct Rollout {
  DriveCommand target;                           ///< wheel speeds that it settles at
  std::array<Point2, kRolloutSamples> points_W;  ///< evenly spaced in time, the last is its end
  Pose2 end_W;
  double own_cost_m = 0.0;
  double length_m = 0.0;
  double score_m = 0.0;   ///< the least is best; infinite where it is not to be driven
  bool collides = false;  ///< a part of the vehicle would enter a lethal cell of C-space
};

/// Not thread-safe; allocates at construction only.
class RolloutPlanner {
 public:
  /// What all roll-outs of one step start from.
  struct Situation {
    Pose2 X_WB;
    DriveCommand wheels;  ///< present speeds
    const GridWindow& window;
    const CostMap& map;
  };

  RolloutPlanner(const RolloutParams& params, const VehicleParams& vehicle);

  /// What they are for.
  struct Aim {
    Point2 goal_W;
    double goal_tolerance_m = 0.0;  ///< a roll-out that comes so near ends there
    Point2 near_W;                  ///< the path's point that a turn on the spot turns to
    double speed_limit_mps = 0.0;
  };

  /// Makes and scores all roll-outs; `dstar` must just have replanned over situation.map. Returns the best
  /// one's index, -1 if none is free.
  int plan(const Situation& situation, DStar& dstar, const Aim& aim);
  std::span<const Rollout> rollouts() const { return rollouts_; }

  /// Whether driving towards `target` wheel speeds for so long keeps clear of lethal cells.
  bool is_free(const Situation& situation, const DriveCommand& target, double duration_s) const;

  /// The wheel speeds nearest to `target` that can be reached from `from` in `dt_s`.
  DriveCommand approach(const DriveCommand& from, const DriveCommand& target, double dt_s) const;

 private:
  struct Traced {
    double own_cost_m = 0.0;
    double length_m = 0.0;
    TraversalCost highest = kFreeCost;
  };

  void make_targets(const Situation& situation, const Aim& aim);
  void add_target(double v_mps, double yaw_rate_radps);
  Traced trace(const Situation& situation, Rollout& rollout, double duration_s, const Aim* aim) const;
  TraversalCost body_cost(const Situation& situation, const Pose2& X_WB) const;
  TraversalCost axle_cost(const Situation& situation, const Pose2& X_WB) const;
  double permitted_speed(TraversalCost highest) const;
  double cost_from(const Situation& situation, DStar& dstar, const Point2& p_W, int& best_cell) const;
  double score(const Situation& situation, DStar& dstar, const Rollout& rollout) const;

  RolloutParams params_;
  VehicleParams vehicle_;
  std::vector<double> discs_m_;
  std::vector<Rollout> rollouts_;
};

}  // namespace hindsight
