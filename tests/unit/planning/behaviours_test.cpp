// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Each row of the table in planning/behaviours.h.
#include "planning/behaviours.h"

#include <gtest/gtest.h>

namespace hindsight {
namespace {

class Behaviours : public testing::Test {
 protected:
  Behaviours() {
    in_.has_goal = in_.motion_permitted = in_.path_exists = true;
    params_.attempts = 2;
    machine_ = BehaviourMachine(params_);
  }
  Behaviour after(double seconds) {
    in_.now += from_seconds(seconds);
    const Behaviour state = machine_.step(in_);
    in_.goal_changed = in_.bumper_left = in_.bumper_right = in_.slip = false;
    return state;
  }
  Behaviour move(double forward_m, double turn_rad = 0.0) {
    in_.X_WB.x_m += forward_m;
    in_.X_WB.heading_rad += turn_rad;
    return after(0.1);
  }
  void go_to_follow() { ASSERT_EQ(after(0.1), Behaviour::follow); }
  void go_to_back_up() {
    go_to_follow();
    in_.bumper_left = true;
    ASSERT_EQ(after(0.1), Behaviour::stopping);
    ASSERT_EQ(after(0.1), Behaviour::back_up);
  }
  void go_to_turn_away() {
    go_to_back_up();
    ASSERT_EQ(move(-params_.back_up_m), Behaviour::turn_away);
  }

  BehaviourParams params_;
  BehaviourMachine machine_{params_};
  BehaviourInput in_;
};

TEST_F(Behaviours, Row1WithoutGoalIdle) {
  go_to_back_up();
  in_.has_goal = false;
  EXPECT_EQ(after(0.1), Behaviour::idle);
}

TEST_F(Behaviours, Row2WithoutPermissionHaltedWhateverItDid) {
  go_to_back_up();
  in_.motion_permitted = false;
  EXPECT_EQ(after(0.1), Behaviour::halted);
  in_.bumper_left = true;
  EXPECT_EQ(after(0.1), Behaviour::halted);
}

TEST_F(Behaviours, Row3AnotherGoalIsFollowedFromAnywhere) {
  go_to_follow();
  in_.at_goal = true;
  ASSERT_EQ(after(0.1), Behaviour::arrived);
  in_.at_goal = false;
  ASSERT_EQ(after(0.1), Behaviour::arrived);
  in_.goal_changed = true;
  EXPECT_EQ(after(0.1), Behaviour::follow);
}

TEST_F(Behaviours, Row4PermissionStartsIt) {
  in_.motion_permitted = false;
  ASSERT_EQ(after(0.1), Behaviour::halted);
  in_.motion_permitted = true;
  EXPECT_EQ(after(0.1), Behaviour::follow);
}

TEST_F(Behaviours, Row5BumperOrSlipStopsIt) {
  go_to_follow();
  in_.slip = true;
  EXPECT_EQ(after(0.1), Behaviour::stopping);
}

TEST_F(Behaviours, Row5WhileTurningAway) {
  go_to_turn_away();
  in_.bumper_right = true;
  EXPECT_EQ(after(0.1), Behaviour::stopping);
  EXPECT_EQ(machine_.attempts(), 2);
}

TEST_F(Behaviours, Row5WhileThereIsNoPath) {
  go_to_follow();
  in_.path_exists = false;
  ASSERT_EQ(after(0.1), Behaviour::no_path);
  in_.bumper_right = true;
  EXPECT_EQ(after(0.1), Behaviour::stopping);
}

TEST_F(Behaviours, Row6ArrivesAndStays) {
  go_to_follow();
  in_.at_goal = true;
  EXPECT_EQ(after(0.1), Behaviour::arrived);
  in_.bumper_left = true;
  EXPECT_EQ(after(0.1), Behaviour::arrived);
}

TEST_F(Behaviours, Rows7And9NoPathUntilTheMapChanges) {
  go_to_follow();
  in_.path_exists = false;
  EXPECT_EQ(after(0.1), Behaviour::no_path);
  EXPECT_EQ(after(10.0), Behaviour::no_path);
  in_.path_exists = true;
  EXPECT_EQ(after(0.1), Behaviour::follow);
}

TEST_F(Behaviours, Row8BoxedInForAWhile) {
  go_to_follow();
  in_.rollout_free = false;
  EXPECT_EQ(after(params_.blocked_s * 0.9), Behaviour::follow);
  EXPECT_EQ(after(params_.blocked_s * 0.2), Behaviour::stopping);
}

TEST_F(Behaviours, Row8TurningForEverInOneSpot) {
  go_to_follow();
  for (double t_s = 0.0; t_s < params_.progress_s * 0.95; t_s += 0.1)
    ASSERT_EQ(move(0.0, 0.1), Behaviour::follow);
  move(0.5);
  EXPECT_EQ(after(params_.progress_s * 0.9), Behaviour::follow) << "it had moved on";
  EXPECT_EQ(after(params_.progress_s * 0.2), Behaviour::stopping);
}

TEST_F(Behaviours, Row10WaitsForStandstillButNotForEver) {
  go_to_follow();
  in_.v_mps = 0.5;
  in_.bumper_left = true;
  ASSERT_EQ(after(0.1), Behaviour::stopping);
  EXPECT_EQ(after(params_.stop_s * 0.8), Behaviour::stopping);
  EXPECT_EQ(after(params_.stop_s * 0.3), Behaviour::back_up);
}

TEST_F(Behaviours, Row11StuckAfterTheLastAttemptUntilPermissionIsRenewed) {
  go_to_follow();
  for (int attempt = 1; attempt <= params_.attempts + 1; ++attempt) {
    in_.bumper_left = true;
    ASSERT_EQ(after(0.1), Behaviour::stopping);
    if (attempt > params_.attempts) break;
    ASSERT_EQ(after(0.1), Behaviour::back_up);
    ASSERT_EQ(move(-params_.back_up_m), Behaviour::turn_away);
    ASSERT_EQ(move(params_.back_up_m, params_.turn_rad), Behaviour::follow);
  }
  EXPECT_EQ(after(0.1), Behaviour::stuck);
  EXPECT_EQ(after(100.0), Behaviour::stuck);
  in_.motion_permitted = false;
  ASSERT_EQ(after(0.1), Behaviour::halted);
  in_.motion_permitted = true;
  EXPECT_EQ(after(0.1), Behaviour::follow);
  EXPECT_EQ(machine_.attempts(), 0);
}

TEST_F(Behaviours, AttemptsInAnotherPlaceCountFromOne) {
  go_to_turn_away();
  ASSERT_EQ(move(0.0, params_.turn_rad), Behaviour::follow);
  move(params_.attempt_radius_m * 2);
  in_.slip = true;
  ASSERT_EQ(after(0.1), Behaviour::stopping);
  EXPECT_EQ(machine_.attempts(), 1);
}

TEST_F(Behaviours, Row12BacksUpFarEnough) {
  go_to_back_up();
  EXPECT_EQ(move(-params_.back_up_m * 0.5), Behaviour::back_up);
  EXPECT_EQ(move(-params_.back_up_m * 0.6), Behaviour::turn_away);
}

TEST_F(Behaviours, Row12GivesUpWhereThePoseStays) {
  go_to_back_up();
  EXPECT_EQ(after(params_.stall_s * 0.9), Behaviour::back_up);
  EXPECT_EQ(after(params_.stall_s * 0.2), Behaviour::turn_away);
}

TEST_F(Behaviours, Row12GivesUpAfterItsTime) {
  params_.back_up_m = 3.0;
  machine_ = BehaviourMachine(params_);
  go_to_back_up();
  const int steps = static_cast<int>(params_.back_up_s);
  for (int k = 1; k < steps; ++k) {
    in_.X_WB.x_m -= 0.1;
    ASSERT_EQ(after(1.0), Behaviour::back_up);
  }
  in_.X_WB.x_m -= 0.1;
  EXPECT_EQ(after(1.0), Behaviour::turn_away);
}

TEST_F(Behaviours, Row12StopsBeforeKnownLethalGroundBehind) {
  go_to_back_up();
  in_.behind_free = false;
  EXPECT_EQ(after(0.1), Behaviour::turn_away);
}

TEST_F(Behaviours, Row13TurnsAwayFromTheSideThatTouched) {
  go_to_turn_away();
  EXPECT_EQ(machine_.turn_direction(), -1) << "left bumper: to the right";
  EXPECT_EQ(move(0.0, -params_.turn_rad * 0.5), Behaviour::turn_away);
  EXPECT_EQ(move(0.0, -params_.turn_rad * 0.6), Behaviour::follow);
}

TEST_F(Behaviours, Row13SlipTurnsToThePathsSide) {
  go_to_follow();
  in_.slip = in_.path_to_left = true;
  after(0.1);
  EXPECT_EQ(machine_.turn_direction(), 1);
}

TEST_F(Behaviours, Row13GivesUpWhereTheHeadingStaysOrThereIsNoRoom) {
  go_to_turn_away();
  EXPECT_EQ(after(params_.stall_s * 1.1), Behaviour::follow);
  go_to_turn_away();
  in_.turn_right_free = false;
  EXPECT_EQ(after(0.1), Behaviour::follow);
}

TEST_F(Behaviours, Row14StuckIgnoresTouches) {
  params_.attempts = 1;
  machine_ = BehaviourMachine(params_);
  go_to_turn_away();
  in_.bumper_left = true;
  after(0.1);
  ASSERT_EQ(after(0.1), Behaviour::stuck);
  in_.slip = true;
  EXPECT_EQ(after(0.1), Behaviour::stuck);
  in_.goal_changed = true;
  EXPECT_EQ(after(0.1), Behaviour::follow);
}

}  // namespace
}  // namespace hindsight
