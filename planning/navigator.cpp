// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "planning/navigator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planning/body_discs.h"

namespace hindsight {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// How far ahead the map is looked at before backing up or turning [s].
constexpr double kGlance_s = 0.6;
// A turn on the spot turns to the path's point so far ahead [m].
constexpr double kNear_m = 0.8;
// Braking for the goal leaves this much of the vehicle's deceleration unused.
constexpr double kBrakeShare = 0.3;

double distance_m(const Pose2& X_WB, const Point2& p_W) {
  return std::hypot(p_W.x_m - X_WB.x_m, p_W.y_m - X_WB.y_m);
}

Point2 centre(const GridWindow& window, Cell cell) {
  return {(cell.i + 0.5) * window.resolution_m, (cell.j + 0.5) * window.resolution_m};
}

}  // namespace

Navigator::Navigator(const PlanningParams& params, const VehicleParams& vehicle, int window_cells,
                     double resolution_m)
    : params_(params),
      vehicle_(vehicle),
      cost_map_(params.cost_map, vehicle, window_cells, resolution_m),
      dstar_(window_cells, window_cells),
      rollouts_(params.rollouts, vehicle),
      behaviours_(params.behaviours),
      discs_m_(body_discs_m(vehicle)) {
  const auto cells = static_cast<std::size_t>(dstar_.width()) * static_cast<std::size_t>(dstar_.height());
  body_cells_.reserve(discs_m_.size());
  seeds_.reserve(cells);
  path_cells_.resize(cells);
  path_W_.reserve(cells);
}

const NavigatorOutput& Navigator::step(const NavigatorInput& input) {
  output_ = {};
  locate_body(input);
  update_map(input);
  update_goal(input);
  replan(input);
  output_.behaviour = behaviours_.step(observe(input));
  output_.reached = output_.behaviour == Behaviour::arrived;
  output_.command = last_command_ = drive(input);
  return output_;
}

void Navigator::locate_body(const NavigatorInput& input) {
  const GridWindow& window = *input.window;
  const Cell robot = window.cell_at(input.X_WB.x_m, input.X_WB.y_m);
  robot_cell_ = window.contains(robot) ? window.index(robot) : -1;
  body_cells_.clear();
  for (const double x_B_m : discs_m_) {
    const Point2 p_W = input.X_WB * Point2{x_B_m, 0.0};
    const Cell cell = window.cell_at(p_W.x_m, p_W.y_m);
    if (window.contains(cell)) body_cells_.push_back(window.index(cell));
  }
}

void Navigator::update_map(const NavigatorInput& input) {
  if (input.window_moved) {
    cost_map_.rebuild(input.window_costs, body_cells_);
    dstar_.init(cost_map_.costs());
  } else {
    dstar_.set_costs(cost_map_.update(*input.window, input.changes, body_cells_));
  }
}

void Navigator::update_goal(const NavigatorInput& input) {
  const bool same = goal_W_.has_value() == input.goal_W.has_value() &&
                    (!goal_W_ || (goal_W_->x_m == input.goal_W->x_m && goal_W_->y_m == input.goal_W->y_m));
  goal_changed_ = !same;
  if (same && !input.window_moved) return;
  goal_W_ = input.goal_W;
  seeds_.clear();
  if (goal_W_) {
    const GridWindow& window = *input.window;
    if (window.contains(window.cell_at(goal_W_->x_m, goal_W_->y_m))) {
      seed_goal_inside(window, *goal_W_);
    } else {
      seed_goal_outside(window, *goal_W_);
    }
  }
  dstar_.set_goal(seeds_);
}

// Every cell within the tolerance will do, so that a goal inside an obstacle's margin can still be reached.
void Navigator::seed_goal_inside(const GridWindow& window, const Point2& goal_W) {
  const Cell goal = window.cell_at(goal_W.x_m, goal_W.y_m);
  const double reach_m = std::max(0.0, params_.behaviours.goal_tolerance_m - window.resolution_m);
  const int reach = static_cast<int>(reach_m / window.resolution_m);
  add_seed(window, goal, goal_W);
  for (int j = goal.j - reach; j <= goal.j + reach; ++j) {
    for (int i = goal.i - reach; i <= goal.i + reach; ++i) {
      const Point2 p_W = centre(window, {i, j});
      if (!window.contains({i, j}) || Cell{i, j} == goal) continue;
      if (std::hypot(p_W.x_m - goal_W.x_m, p_W.y_m - goal_W.y_m) <= reach_m) add_seed(window, {i, j}, goal_W);
    }
  }
}

// The thesis' heuristic for the cost from the local map's edge to the goal: the straight line over free
// ground.
void Navigator::seed_goal_outside(const GridWindow& window, const Point2& goal_W) {
  const int last = window.size_cells - 1;
  for (int k = 0; k < last; ++k) {
    add_seed(window, {window.origin.i + k, window.origin.j}, goal_W);
    add_seed(window, {window.origin.i + last, window.origin.j + k}, goal_W);
    add_seed(window, {window.origin.i + last - k, window.origin.j + last}, goal_W);
    add_seed(window, {window.origin.i, window.origin.j + last - k}, goal_W);
  }
}

void Navigator::add_seed(const GridWindow& window, Cell cell, const Point2& goal_W) {
  const Point2 p_W = centre(window, cell);
  const double cells = std::hypot(p_W.x_m - goal_W.x_m, p_W.y_m - goal_W.y_m) / window.resolution_m;
  // A goal beyond all numbers still has a direction.
  const double extra = std::min(cells * kCellUnit, static_cast<double>(kUnreachable / 2));
  seeds_.push_back({window.index(cell), static_cast<PathCost>(std::lround(extra))});
}

void Navigator::replan(const NavigatorInput& input) {
  path_W_.clear();
  output_.cost_to_goal = kInfinity;
  if (!goal_W_ || robot_cell_ < 0) return;
  const PathCost cost = dstar_.replan(robot_cell_);
  output_.expansions = dstar_.expansions();
  if (cost == kUnreachable) return;
  const GridWindow& window = *input.window;
  output_.cost_to_goal = cost * window.resolution_m / kCellUnit;
  const int count = dstar_.extract_path(path_cells_);
  for (int k = 0; k < count; ++k) {
    const int cell = path_cells_[static_cast<std::size_t>(k)];
    path_W_.push_back(centre(
        window, {window.origin.i + cell % window.size_cells, window.origin.j + cell / window.size_cells}));
  }
  output_.path_W = path_W_;
}

// The path's point a little ahead, or its end, or the goal where there is no path.
Point2 Navigator::near_path_point(const NavigatorInput& input) const {
  for (const Point2& p_W : path_W_)
    if (distance_m(input.X_WB, p_W) >= kNear_m) return p_W;
  return !path_W_.empty() ? path_W_.back() : goal_W_.value_or(Point2{input.X_WB.x_m, input.X_WB.y_m});
}

BehaviourInput Navigator::observe(const NavigatorInput& input) const {
  BehaviourInput seen;
  seen.now = input.now;
  seen.X_WB = input.X_WB;
  seen.v_mps = input.v_mps;
  seen.has_goal = goal_W_.has_value();
  seen.goal_changed = goal_changed_;
  seen.motion_permitted = input.motion_permitted;
  seen.at_goal = goal_W_ && distance_m(input.X_WB, *goal_W_) <= params_.behaviours.goal_tolerance_m;
  seen.path_exists = !path_W_.empty();
  seen.rollout_free = rollout_free_;
  seen.bumper_left = input.bumper_left;
  seen.bumper_right = input.bumper_right;
  seen.slip = input.slip;
  const RolloutPlanner::Situation now = situation(input);
  const double back_mps = -params_.behaviours.back_up_mps;
  seen.behind_free = rollouts_.is_free(now, {back_mps, back_mps}, kGlance_s);
  seen.turn_left_free = rollouts_.is_free(now, turn_command(1), kGlance_s);
  seen.turn_right_free = rollouts_.is_free(now, turn_command(-1), kGlance_s);
  seen.path_to_left = input.X_WB.inverse_times(near_path_point(input)).y_m > 0.0;
  return seen;
}

DriveCommand Navigator::drive(const NavigatorInput& input) {
  rollout_free_ = true;
  const double back_mps = -params_.behaviours.back_up_mps;
  switch (output_.behaviour) {
    case Behaviour::follow:
      return follow(input);
    case Behaviour::back_up:
      return rollouts_.approach(last_command_, {back_mps, back_mps}, input.dt_s);
    case Behaviour::turn_away:
      return rollouts_.approach(last_command_, turn_command(behaviours_.turn_direction()), input.dt_s);
    default:
      return {};
  }
}

DriveCommand Navigator::follow(const NavigatorInput& input) {
  if (path_W_.empty()) return {};
  const RolloutPlanner::Aim aim{*goal_W_, params_.behaviours.goal_tolerance_m, near_path_point(input),
                                speed_limit(input)};
  const int best = rollouts_.plan(situation(input), dstar_, aim);
  output_.rollouts = rollouts_.rollouts();
  output_.chosen = best;
  output_.expansions = dstar_.expansions();
  rollout_free_ = best >= 0;
  const DriveCommand target =
      best >= 0 ? output_.rollouts[static_cast<std::size_t>(best)].target : DriveCommand{};
  return rollouts_.approach(last_command_, target, input.dt_s);
}

double Navigator::speed_limit(const NavigatorInput& input) const {
  if (input.ir_left || input.ir_right) return params_.rollouts.slow_mps;
  const double left_m =
      std::max(0.0, distance_m(input.X_WB, *goal_W_) - params_.behaviours.goal_tolerance_m / 2);
  const double braking_mps = std::sqrt(2 * kBrakeShare * vehicle_.max_acceleration_mps2 * left_m);
  return std::max(braking_mps, params_.rollouts.slow_mps);
}

// Roll-outs start from what was last commanded: with the measured speeds a command of a tick's acceleration
// would never overcome a drive's lag.
RolloutPlanner::Situation Navigator::situation(const NavigatorInput& input) const {
  return {input.X_WB, last_command_, *input.window, cost_map_};
}

DriveCommand Navigator::turn_command(int direction) const {
  const double wheel_mps = direction * std::min(params_.rollouts.turn_mps, vehicle_.max_speed_mps);
  return {-wheel_mps, wheel_mps};
}

}  // namespace hindsight
