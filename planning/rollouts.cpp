// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "planning/rollouts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planning/body_discs.h"

namespace hindsight {

namespace {

constexpr int kSpeeds = 4;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
// What a radian of turning costs, so that turning about is never free [m/rad].
constexpr double kTurnCost = 0.05;
// Closer to a point than this its bearing says nothing [m].
constexpr double kNoBearing = 0.3;
// The path that leads on from a roll-out's end is looked along for so many cells.
constexpr int kCellsAhead = 5;
// Facing the path so well, a turn on the spot would only stand still.
constexpr double kFacing_rad = 0.2;

double step_towards(double from, double target, double most) {
  return from + std::clamp(target - from, -most, most);
}

// Moves the pose by wheel speeds that change linearly from `a` to `b` over dt: along the chord of the arc.
void advance(Pose2& X_WB, const DriveCommand& a, const DriveCommand& b, double track_m, double dt_s) {
  const double left_m = (a.left_mps + b.left_mps) / 2 * dt_s,
               right_m = (a.right_mps + b.right_mps) / 2 * dt_s;
  const double turn_rad = (right_m - left_m) / track_m, forward_m = (left_m + right_m) / 2;
  const double along_rad = X_WB.heading_rad + turn_rad / 2;
  X_WB.x_m += forward_m * std::cos(along_rad);
  X_WB.y_m += forward_m * std::sin(along_rad);
  X_WB.heading_rad = wrap_angle(X_WB.heading_rad + turn_rad);
}

// How far the body has to turn to face the point; `otherwise` where it is too near to tell.
double bearing_rad(const Pose2& X_WB, const Point2& p_W, double otherwise) {
  const Point2 p_B = X_WB.inverse_times(p_W);
  return std::hypot(p_B.x_m, p_B.y_m) < kNoBearing ? otherwise : std::atan2(p_B.y_m, p_B.x_m);
}

}  // namespace

RolloutPlanner::RolloutPlanner(const RolloutParams& params, const VehicleParams& vehicle)
    : params_(params), vehicle_(vehicle), discs_m_(body_discs_m(vehicle)) {
  rollouts_.reserve(static_cast<std::size_t>(kSpeeds * params.curvatures + 1));
}

int RolloutPlanner::plan(const Situation& situation, DStar& dstar, const Aim& aim) {
  make_targets(situation, aim);
  int best = -1;
  double best_score = kInfinity;
  for (std::size_t i = 0; i < rollouts_.size(); ++i) {
    Rollout& rollout = rollouts_[i];
    const Traced traced = trace(situation, rollout, params_.horizon_s, &aim);
    rollout.own_cost_m = traced.own_cost_m;
    rollout.length_m = traced.length_m;
    rollout.collides = traced.highest == kLethalCost;
    const double speed_mps = std::abs(rollout.target.left_mps + rollout.target.right_mps) / 2;
    const bool drivable = !rollout.collides && speed_mps <= permitted_speed(traced.highest) + 1e-9;
    rollout.score_m = drivable ? score(situation, dstar, rollout) : kInfinity;
    if (rollout.score_m >= best_score) continue;
    best_score = rollout.score_m;
    best = static_cast<int>(i);
  }
  return best;
}

bool RolloutPlanner::is_free(const Situation& situation, const DriveCommand& target,
                             double duration_s) const {
  Rollout rollout;
  rollout.target = target;
  return trace(situation, rollout, duration_s, nullptr).highest != kLethalCost;
}

DriveCommand RolloutPlanner::approach(const DriveCommand& from, const DriveCommand& target,
                                      double dt_s) const {
  const double most = vehicle_.max_acceleration_mps2 * dt_s;
  return {step_towards(from.left_mps, target.left_mps, most),
          step_towards(from.right_mps, target.right_mps, most)};
}

void RolloutPlanner::make_targets(const Situation& situation, const Aim& aim) {
  rollouts_.clear();
  const double fast = std::min({params_.cruise_mps, vehicle_.max_speed_mps, aim.speed_limit_mps});
  const double slow = std::min(params_.slow_mps, fast);
  for (const double v_mps : {fast, (fast + slow) / 2, slow, slow / 2}) {
    for (int k = 0; k < params_.curvatures; ++k) {
      const double share = 2.0 * k / (params_.curvatures - 1) - 1.0;  // finer around straight ahead
      add_target(v_mps, v_mps * params_.max_curvature_per_m * share * std::abs(share));
    }
  }
  // On the spot: as fast as brings the vehicle to face the path in half the horizon, so that it does not turn
  // past it.
  const double off_rad = bearing_rad(situation.X_WB, aim.near_W, 0.0);
  const double most_radps = 2 * std::min(params_.turn_mps, vehicle_.max_speed_mps) / vehicle_.track_width_m;
  if (std::abs(off_rad) < kFacing_rad) return;
  add_target(0.0, std::clamp(2 * off_rad / params_.horizon_s, -most_radps, most_radps));
}

void RolloutPlanner::add_target(double v_mps, double yaw_rate_radps) {
  const double half = yaw_rate_radps * vehicle_.track_width_m / 2;
  // A wheel too fast: slower along the same arc.
  const double scale =
      std::min(1.0, vehicle_.max_speed_mps / std::max(1e-9, std::abs(v_mps) + std::abs(half)));
  Rollout rollout;
  rollout.target = {(v_mps - half) * scale, (v_mps + half) * scale};
  rollouts_.push_back(rollout);
}

RolloutPlanner::Traced RolloutPlanner::trace(const Situation& situation, Rollout& rollout, double duration_s,
                                             const Aim* aim) const {
  const double dt_s = duration_s / kRolloutSamples;
  Traced traced;
  Pose2 X_WB = situation.X_WB;
  DriveCommand wheels = situation.wheels;
  bool there = false;
  for (Point2& point : rollout.points_W) {
    if (!there) {
      const Pose2 from = X_WB;
      const DriveCommand next = approach(wheels, rollout.target, dt_s);
      advance(X_WB, wheels, next, vehicle_.track_width_m, dt_s);
      wheels = next;
      traced.highest = std::max(traced.highest, body_cost(situation, X_WB));
      const double step_m = std::hypot(X_WB.x_m - from.x_m, X_WB.y_m - from.y_m);
      traced.length_m += step_m;
      traced.own_cost_m += axle_cost(situation, X_WB) * step_m +
                           kTurnCost * std::abs(wrap_angle(X_WB.heading_rad - from.heading_rad));
      there = aim != nullptr &&
              std::hypot(aim->goal_W.x_m - X_WB.x_m, aim->goal_W.y_m - X_WB.y_m) <= aim->goal_tolerance_m;
    }
    point = {X_WB.x_m, X_WB.y_m};
  }
  rollout.end_W = X_WB;
  return traced;
}

TraversalCost RolloutPlanner::body_cost(const Situation& situation, const Pose2& X_WB) const {
  TraversalCost highest = kFreeCost;
  for (const double x_B_m : discs_m_) {
    const Point2 p_W = X_WB * Point2{x_B_m, 0.0};
    const Cell cell = situation.window.cell_at(p_W.x_m, p_W.y_m);
    if (!situation.window.contains(cell)) return kLethalCost;
    highest = std::max(highest, situation.map.cost(situation.window.index(cell)));
  }
  return highest;
}

// What the global path counts: the same for a roll-out, so that following the path is never dearer than
// standing.
TraversalCost RolloutPlanner::axle_cost(const Situation& situation, const Pose2& X_WB) const {
  const Cell cell = situation.window.cell_at(X_WB.x_m, X_WB.y_m);
  return situation.window.contains(cell) ? situation.map.cost(situation.window.index(cell)) : kLethalCost;
}

double RolloutPlanner::permitted_speed(TraversalCost highest) const {
  return highest < params_.careful_cost ? kInfinity : params_.slow_mps;
}

// The best of the four cells around the point: the distance to its centre and on from there.
double RolloutPlanner::cost_from(const Situation& situation, DStar& dstar, const Point2& p_W,
                                 int& best_cell) const {
  const GridWindow& window = situation.window;
  const double resolution_m = window.resolution_m;
  const Cell low = window.cell_at(p_W.x_m - resolution_m / 2, p_W.y_m - resolution_m / 2);
  double best_m = kInfinity;
  for (int j = low.j; j <= low.j + 1; ++j) {
    for (int i = low.i; i <= low.i + 1; ++i) {
      if (!window.contains({i, j})) continue;
      const int cell = window.index({i, j});
      if (situation.map.cost(cell) == kLethalCost) continue;
      const PathCost on = dstar.cost_to_goal(cell);
      if (on == kUnreachable) continue;
      const double there_m =
          std::hypot((i + 0.5) * resolution_m - p_W.x_m, (j + 0.5) * resolution_m - p_W.y_m);
      const double cost_m = there_m * situation.map.cost(cell) + on * resolution_m / kCellUnit;
      if (cost_m >= best_m) continue;
      best_m = cost_m;
      best_cell = cell;
    }
  }
  return best_m;
}

double RolloutPlanner::score(const Situation& situation, DStar& dstar, const Rollout& rollout) const {
  const GridWindow& window = situation.window;
  int cell = -1;
  const double on_m = cost_from(situation, dstar, {rollout.end_W.x_m, rollout.end_W.y_m}, cell);
  if (cell < 0) return kInfinity;
  const int ahead = dstar.descend(cell, kCellsAhead);
  const Point2 ahead_W{(window.origin.i + ahead % window.size_cells + 0.5) * window.resolution_m,
                       (window.origin.j + ahead / window.size_cells + 0.5) * window.resolution_m};
  const double change_mps = std::abs(rollout.target.left_mps - situation.wheels.left_mps) +
                            std::abs(rollout.target.right_mps - situation.wheels.right_mps);
  return on_m + params_.own_cost_weight * rollout.own_cost_m - params_.progress_weight * rollout.length_m +
         params_.heading_weight_m_per_rad * std::abs(bearing_rad(rollout.end_W, ahead_W, 0.0)) +
         params_.change_weight_s * change_mps;
}

}  // namespace hindsight
