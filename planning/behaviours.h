// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What the robot does: a small state machine over what planning found and what the robot met (thesis 5.1:
// after a touch or slip "back up, mark the spot as an obstacle in the grid, try another route"; the grid
// marks the spot).
//
//   row  from                         when                                                   to
//    1   any                          there is no goal                                       idle
//    2   any                          motion is not permitted                                halted
//    3   any                          the goal is another one (attempts forgotten)           follow
//    4   idle, halted                 a goal and permission (attempts forgotten)             follow
//    5   follow, turn_away, no_path   bumper or slip                                         stopping
//    6   follow                       within the goal's tolerance                            arrived
//    7   follow                       no way on the map                                      no_path
//    8   follow                       no roll-out is free for blocked_s, or the robot is     stopping
//                                     where it was for progress_s
//    9   no_path                      there is a way again                                   follow
//   10   stopping                     stands, or stop_s is over                              back_up
//   11   stopping                     the same, at the attempt after the last                stuck
//   12   back_up                      far enough, back_up_s over, pose stays for stall_s,    turn_away
//                                     or the ground behind is known to be lethal
//   13   turn_away                    turned enough, turn_s over, heading stays for          follow
//                                     stall_s, or no room to turn
//   14   arrived, stuck               (only rows 1 to 3)
//
// Rows 1 to 3 are tried first, in this order. An attempt is one entry into stopping; attempts count from 1
// again once the robot is attempt_radius_m away from where they began.
//
// Pure: time and pose come in as data. A state entered is acted on in the same step.
#pragma once

#include <cstdint>

#include "config/params.h"
#include "drivers/samples.h"
#include "perception/pose.h"

namespace hindsight {

/// What the robot is doing.
enum class Behaviour : std::uint8_t {
  idle = 0,       ///< no goal
  halted = 1,     ///< motion is not permitted
  follow = 2,     ///< along the best roll-out
  stopping = 3,   ///< after a bumper hit or slip, or boxed in: until it stands
  back_up = 4,    ///< blindly, a short way
  turn_away = 5,  ///< on the spot, away from what it met
  arrived = 6,    ///< within the goal's tolerance
  no_path = 7,    ///< no way on the present map; stands until it changes
  stuck = 8       ///< too many attempts in one place; stands until the goal or the permission is renewed
};

struct BehaviourParams {
  double goal_tolerance_m = 0.8;
  double stop_s = 1.0;
  double stand_mps = 0.05;
  double back_up_m = 0.6;
  double back_up_mps = 0.3;
  double back_up_s = 5.0;
  double turn_rad = 0.7;
  double turn_s = 5.0;
  double stall_s = 1.5;
  double blocked_s = 0.5;
  double progress_s = 10.0;
  int attempts = 10;
  double attempt_radius_m = 2.0;

  void visit(auto&& param) {
    param("goal_tolerance_m", goal_tolerance_m, Range{0.1, 20.0}, "so near, the goal is reached [m]");
    param("stop_s", stop_s, Range{0.0, 10.0}, "longest wait for standstill before backing up [s]");
    param("stand_mps", stand_mps, Range{0.0, 1.0}, "slower than this is standing [m/s]");
    param("back_up_m", back_up_m, Range{0.0, 3.0}, "how far to back up, blindly [m]");
    param("back_up_mps", back_up_mps, Range{0.05, 1.0}, "how fast to back up [m/s]");
    param("back_up_s", back_up_s, Range{0.1, 60.0}, "longest time to back up [s]");
    param("turn_rad", turn_rad, Range{0.0, 3.2}, "how far to turn away [rad]");
    param("turn_s", turn_s, Range{0.1, 60.0}, "longest time to turn away [s]");
    param("stall_s", stall_s, Range{0.1, 30.0}, "give a recovery up if the pose stays for this long [s]");
    param("blocked_s", blocked_s, Range{0.0, 30.0}, "so long without a free roll-out before backing up [s]");
    param("progress_s", progress_s, Range{1.0, 600.0},
          "so long in one spot while following before backing up [s]");
    param("attempts", attempts, Range{1, 1000}, "recoveries in one place before giving up");
    param("attempt_radius_m", attempt_radius_m, Range{0.1, 50.0}, "size of one place [m]");
  }
};

struct BehaviourInput {
  Time now{};
  Pose2 X_WB;
  double v_mps = 0.0;
  bool has_goal = false;
  bool goal_changed = false;
  bool motion_permitted = false;
  bool at_goal = false;
  bool path_exists = false;
  bool rollout_free = true;  ///< in the last step that followed
  bool bumper_left = false;
  bool bumper_right = false;
  bool slip = false;
  bool behind_free = true;  ///< as far as the map knows
  bool turn_left_free = true;
  bool turn_right_free = true;
  bool path_to_left = false;  ///< on which side the path leads on
};

/// Not thread-safe.
class BehaviourMachine {
 public:
  explicit BehaviourMachine(const BehaviourParams& params) : params_(params) {}

  Behaviour step(const BehaviourInput& input);

  Behaviour state() const { return state_; }
  /// In turn_away: +1 to the left, -1 to the right.
  int turn_direction() const { return turn_direction_; }
  int attempts() const { return attempts_; }

 private:
  Behaviour next(const BehaviourInput& input) const;
  void enter(Behaviour state, const BehaviourInput& input);
  void count_attempt(const BehaviourInput& input);
  void choose_turn(const BehaviourInput& input);
  void watch_motion(const BehaviourInput& input);
  bool met_something(const BehaviourInput& input) const;
  bool boxed_in(const BehaviourInput& input) const;
  bool backed_enough(const BehaviourInput& input) const;
  bool turned_enough(const BehaviourInput& input) const;
  double seconds_in_state(const BehaviourInput& input) const { return to_seconds(input.now - entered_); }

  BehaviourParams params_;
  Behaviour state_ = Behaviour::idle;
  Time entered_{};
  Pose2 entered_X_WB_;
  Time moved_{};  ///< when the pose last differed from moved_X_WB_
  Pose2 moved_X_WB_;
  Time progressed_{};  ///< when the robot was last away from progressed_X_WB_
  Pose2 progressed_X_WB_;
  Time free_{};  ///< when a roll-out was last free
  Point2 attempts_p_W_;
  int attempts_ = 0;
  int turn_direction_ = 1;
};

}  // namespace hindsight
