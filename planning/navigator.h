// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Planning as one pure step: grid costs -> C-space -> D* -> roll-outs -> behaviours -> drive command
// (thesis 5.1, 5.2.4).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "drivers/samples.h"
#include "perception/evidence_grid_geometry.h"
#include "perception/pose.h"
#include "planning/behaviours.h"
#include "planning/cost_map.h"
#include "planning/dstar.h"
#include "planning/rollouts.h"

namespace hindsight {

struct PlanningParams {
  CostMapParams cost_map;
  RolloutParams rollouts;
  BehaviourParams behaviours;
};

struct NavigatorInput {
  Time now{};
  Pose2 X_WB;
  double v_mps = 0.0;  ///< measured, forward
  double yaw_rate_radps = 0.0;
  const GridWindow* window = nullptr;      ///< never null
  bool window_moved = false;               ///< true also for the first step
  std::span<const CellCost> window_costs;  ///< the whole window, row-major; only where it moved
  std::span<const CellChange> changes;     ///< since the last step; ignored where the window moved
  std::optional<Point2> goal_W;
  bool bumper_left = false;  ///< pressed now or since the last step
  bool bumper_right = false;
  bool slip = false;
  bool ir_left = false;  ///< something nearer than the sensor's range
  bool ir_right = false;
  bool motion_permitted = false;
  double dt_s = 0.1;  ///< since the last step
};

struct NavigatorOutput {
  DriveCommand command;
  Behaviour behaviour = Behaviour::idle;
  std::span<const Point2> path_W;     ///< D*'s path from the robot on; empty where there is none
  std::span<const Rollout> rollouts;  ///< empty unless following
  int chosen = -1;                    ///< index into rollouts, -1 where none is driven
  double cost_to_goal = 0.0;          ///< in metres of free ground; infinite where there is no way
  bool reached = false;
  int expansions = 0;  ///< cells that D* expanded in this step
};

/// Not thread-safe; allocates at construction only. A start outside the window counts as having no path.
class Navigator {
 public:
  Navigator(const PlanningParams& params, const VehicleParams& vehicle, int window_cells,
            double resolution_m);

  /// The result stays valid until the next call.
  const NavigatorOutput& step(const NavigatorInput& input);

 private:
  void locate_body(const NavigatorInput& input);
  void update_map(const NavigatorInput& input);
  void update_goal(const NavigatorInput& input);
  void seed_goal_inside(const GridWindow& window, const Point2& goal_W);
  void seed_goal_outside(const GridWindow& window, const Point2& goal_W);
  void add_seed(const GridWindow& window, Cell cell, const Point2& goal_W);
  void replan(const NavigatorInput& input);
  Point2 near_path_point(const NavigatorInput& input) const;
  BehaviourInput observe(const NavigatorInput& input) const;
  DriveCommand drive(const NavigatorInput& input);
  DriveCommand follow(const NavigatorInput& input);
  double speed_limit(const NavigatorInput& input) const;
  RolloutPlanner::Situation situation(const NavigatorInput& input) const;
  DriveCommand turn_command(int direction) const;

  PlanningParams params_;
  VehicleParams vehicle_;
  CostMap cost_map_;
  DStar dstar_;
  RolloutPlanner rollouts_;
  BehaviourMachine behaviours_;
  std::vector<double> discs_m_;
  std::vector<int> body_cells_;
  int robot_cell_ = -1;  ///< -1: outside the window
  std::optional<Point2> goal_W_;
  bool goal_changed_ = false;
  std::vector<GoalSeed> seeds_;
  std::vector<int> path_cells_;
  std::vector<Point2> path_W_;
  DriveCommand last_command_;
  bool rollout_free_ = true;
  NavigatorOutput output_;
};

}  // namespace hindsight
