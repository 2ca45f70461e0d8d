// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/road_guide.h"

#include <gtest/gtest.h>

namespace hindsight {
namespace {

/// Straight ahead, `aside_m` to the left.
RoadOnGround straight(double aside_m) {
  RoadOnGround road;
  for (int i = 0; i < 10; ++i)
    road.section[static_cast<std::size_t>(road.count++)] = {{i + 1.0, aside_m + 1.5},
                                                            {i + 1.0, aside_m - 1.5}};
  return road;
}

TEST(RoadGuide, LeadsAlongTheMiddleOfTheRoad) {
  RoadGuide guide(5.0);
  const auto goal = guide.goal_W({10.0, 20.0, 0.0}, straight(0.0), {}, Behaviour::follow);
  ASSERT_TRUE(goal);
  EXPECT_NEAR(goal->x_m, 15.0, 1e-9);
  EXPECT_NEAR(goal->y_m, 20.0, 1e-9);
}

TEST(RoadGuide, AGoalStaysUntilTheRoadHasMovedOn) {
  RoadGuide guide(5.0);
  const auto first = guide.goal_W({}, straight(0.0), {}, Behaviour::follow);
  EXPECT_EQ(guide.goal_W({0.3, 0.0, 0.0}, straight(0.0), {}, Behaviour::follow)->x_m, first->x_m);
  EXPECT_NEAR(guide.goal_W({0.6, 0.0, 0.0}, straight(0.0), {}, Behaviour::follow)->x_m, 5.6, 1e-9);
}

TEST(RoadGuide, DoesNotDisturbARobotThatBacksUp) {
  RoadGuide guide(5.0);
  const auto first = guide.goal_W({}, straight(0.0), {}, Behaviour::follow);
  EXPECT_EQ(guide.goal_W({-2.0, 0.0, 0.0}, straight(1.0), {}, Behaviour::back_up)->x_m, first->x_m);
}

TEST(RoadGuide, NoGoalBeforeARoadWasSeen) {
  RoadGuide guide(5.0);
  EXPECT_FALSE(guide.goal_W({}, RoadOnGround{}, {}, Behaviour::idle));
  EXPECT_FALSE(guide.goal_W({}, RoadOnGround{}, Point2{100.0, 0.0}, Behaviour::idle));
}

TEST(RoadGuide, ALostRoadIsLookedForWhereItWasLastSeenAndNoFarther) {
  RoadGuide guide(5.0);
  const auto last = guide.goal_W({}, straight(0.0), {}, Behaviour::follow);
  const Pose2 turned_away{-0.6, 0.0, -0.7};
  EXPECT_EQ(guide.goal_W(turned_away, RoadOnGround{}, {}, Behaviour::turn_away)->x_m, last->x_m);
  EXPECT_EQ(guide.goal_W(turned_away, RoadOnGround{}, {}, Behaviour::follow)->x_m, last->x_m);
  EXPECT_FALSE(guide.goal_W({4.5, 0.0, 0.0}, RoadOnGround{}, {}, Behaviour::arrived));
  EXPECT_FALSE(guide.goal_W({4.5, 0.0, 0.0}, RoadOnGround{}, {}, Behaviour::idle));
  EXPECT_TRUE(guide.goal_W({4.5, 0.0, 0.0}, straight(0.0), {}, Behaviour::idle)) << "found again";
}

TEST(RoadGuide, TheOperatorsGoalTakesOverOnceItIsNear) {
  RoadGuide guide(5.0);
  EXPECT_NEAR(guide.goal_W({}, straight(0.0), Point2{30.0, 4.0}, Behaviour::follow)->y_m, 0.0, 1e-9);
  EXPECT_EQ(guide.goal_W({28.0, 1.0, 0.0}, straight(0.0), Point2{30.0, 4.0}, Behaviour::follow)->y_m, 4.0);
}

}  // namespace
}  // namespace hindsight
