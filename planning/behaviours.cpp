// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "planning/behaviours.h"

#include <cmath>

namespace hindsight {

namespace {

// Less is what odometry reports of a robot that does not move.
constexpr double kMotion_m = 0.05;
constexpr double kMotion_rad = 0.05;
// Less is turning and shunting in one spot.
constexpr double kProgress_m = 0.4;

double distance_m(const Pose2& a, const Pose2& b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }
double turned_rad(const Pose2& a, const Pose2& b) {
  return std::abs(wrap_angle(a.heading_rad - b.heading_rad));
}

}  // namespace

Behaviour BehaviourMachine::step(const BehaviourInput& input) {
  watch_motion(input);
  const Behaviour to = next(input);
  if (to != state_ || input.goal_changed) enter(to, input);
  return state_;
}

// The numbers are the rows of the table in the header.
Behaviour BehaviourMachine::next(const BehaviourInput& input) const {
  if (!input.has_goal) return Behaviour::idle;            // 1
  if (!input.motion_permitted) return Behaviour::halted;  // 2
  if (input.goal_changed) return Behaviour::follow;       // 3
  switch (state_) {
    case Behaviour::idle:
    case Behaviour::halted:
      return Behaviour::follow;  // 4
    case Behaviour::follow:
      if (met_something(input)) return Behaviour::stopping;  // 5
      if (input.at_goal) return Behaviour::arrived;          // 6
      if (!input.path_exists) return Behaviour::no_path;     // 7
      if (boxed_in(input)) return Behaviour::stopping;       // 8
      break;
    case Behaviour::no_path:
      if (met_something(input)) return Behaviour::stopping;  // 5
      if (input.path_exists) return Behaviour::follow;       // 9
      break;
    case Behaviour::stopping:
      if (std::abs(input.v_mps) >= params_.stand_mps && seconds_in_state(input) < params_.stop_s) break;
      return attempts_ > params_.attempts ? Behaviour::stuck : Behaviour::back_up;  // 11, 10
    case Behaviour::back_up:
      if (backed_enough(input)) return Behaviour::turn_away;  // 12
      break;
    case Behaviour::turn_away:
      if (met_something(input)) return Behaviour::stopping;  // 5
      if (turned_enough(input)) return Behaviour::follow;    // 13
      break;
    case Behaviour::arrived:
    case Behaviour::stuck:
      break;  // 14
  }
  return state_;
}

void BehaviourMachine::enter(Behaviour state, const BehaviourInput& input) {
  if (input.goal_changed || state_ == Behaviour::idle || state_ == Behaviour::halted) attempts_ = 0;
  if (state == Behaviour::stopping) {
    count_attempt(input);
    choose_turn(input);
  }
  state_ = state;
  entered_ = moved_ = free_ = progressed_ = input.now;
  entered_X_WB_ = moved_X_WB_ = progressed_X_WB_ = input.X_WB;
}

void BehaviourMachine::count_attempt(const BehaviourInput& input) {
  const double away_m = std::hypot(input.X_WB.x_m - attempts_p_W_.x_m, input.X_WB.y_m - attempts_p_W_.y_m);
  if (attempts_ == 0 || away_m > params_.attempt_radius_m) {
    attempts_ = 0;
    attempts_p_W_ = {input.X_WB.x_m, input.X_WB.y_m};
  }
  ++attempts_;
}

void BehaviourMachine::choose_turn(const BehaviourInput& input) {
  if (input.bumper_left != input.bumper_right) {
    turn_direction_ = input.bumper_left ? -1 : 1;
  } else {
    turn_direction_ = input.path_to_left ? 1 : -1;
  }
}

void BehaviourMachine::watch_motion(const BehaviourInput& input) {
  if (input.rollout_free) free_ = input.now;
  if (distance_m(input.X_WB, progressed_X_WB_) >= kProgress_m) {
    progressed_ = input.now;
    progressed_X_WB_ = input.X_WB;
  }
  if (distance_m(input.X_WB, moved_X_WB_) < kMotion_m && turned_rad(input.X_WB, moved_X_WB_) < kMotion_rad)
    return;
  moved_ = input.now;
  moved_X_WB_ = input.X_WB;
}

bool BehaviourMachine::met_something(const BehaviourInput& input) const {
  return input.bumper_left || input.bumper_right || input.slip;
}

bool BehaviourMachine::boxed_in(const BehaviourInput& input) const {
  return to_seconds(input.now - free_) > params_.blocked_s ||
         to_seconds(input.now - progressed_) > params_.progress_s;
}

bool BehaviourMachine::backed_enough(const BehaviourInput& input) const {
  return distance_m(input.X_WB, entered_X_WB_) >= params_.back_up_m ||
         seconds_in_state(input) >= params_.back_up_s || to_seconds(input.now - moved_) >= params_.stall_s ||
         !input.behind_free;
}

bool BehaviourMachine::turned_enough(const BehaviourInput& input) const {
  const bool room = turn_direction_ > 0 ? input.turn_left_free : input.turn_right_free;
  return turned_rad(input.X_WB, entered_X_WB_) >= params_.turn_rad ||
         seconds_in_state(input) >= params_.turn_s || to_seconds(input.now - moved_) >= params_.stall_s ||
         !room;
}

}  // namespace hindsight
