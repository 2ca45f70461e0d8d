// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "planning/rollouts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "planning/body_discs.h"
#include "tests/unit/planning/grid_support.h"

namespace hindsight {
namespace {

constexpr int kSide = 100;
const GridWindow kWindow{{0, 0}, kSide, 0.2};
const VehicleParams kVehicle;

// A map with its D*, the goal at (16, 10) m.
struct World {
  CostMap map{CostMapParams{}, kVehicle, kSide, 0.2};
  DStar dstar{kSide, kSide};
  RolloutPlanner planner{RolloutParams{}, kVehicle};

  void set(const std::vector<CellChange>& obstacles, const Pose2& X_WB) {
    map.update(kWindow, obstacles, {});
    dstar.init(map.costs());
    dstar.set_goal(kWindow.index(kWindow.cell_at(16.0, 10.0)));
    dstar.replan(kWindow.index(kWindow.cell_at(X_WB.x_m, X_WB.y_m)));
  }
  int plan(const Pose2& X_WB, const DriveCommand& wheels, double limit_mps = 5.0) {
    return planner.plan({X_WB, wheels, kWindow, map}, dstar, {{16.0, 10.0}, 0.8, {16.0, 10.0}, limit_mps});
  }
  const Rollout& at(int i) const { return planner.rollouts()[static_cast<std::size_t>(i)]; }
};

TEST(BodyDiscs, CoverTheVehicleAndHoldTheAxle) {
  EXPECT_EQ(body_discs_m(kVehicle).size(), 2U);
  VehicleParams longer;
  longer.front_m = 1.6;
  const std::vector<double> discs = body_discs_m(longer);
  EXPECT_DOUBLE_EQ(discs.back(), 1.2);
  EXPECT_NE(std::find(discs.begin(), discs.end(), 0.0), discs.end());
  for (std::size_t i = 1; i < discs.size(); ++i)
    EXPECT_LE(discs[i] - discs[i - 1], longer.width_m / 2 + 1e-12);
}

TEST(Rollouts, DrivesStraightAtTheGoalOverFreeGround) {
  World world;
  const Pose2 X_WB{5.1, 10.1, 0.0};
  world.set({}, X_WB);
  const int best = world.plan(X_WB, {1.0, 1.0});
  ASSERT_GE(best, 0);
  EXPECT_NEAR(world.at(best).target.left_mps, 1.0, 1e-9);
  EXPECT_NEAR(world.at(best).target.right_mps, 1.0, 1e-9);
  EXPECT_NEAR(world.at(best).end_W.x_m, 7.1, 1e-9);
}

TEST(Rollouts, TurnsTowardsAPathBehind) {
  World world;
  const Pose2 X_WB{10.1, 10.1, M_PI - 0.2};
  world.set({}, X_WB);
  const int best = world.plan(X_WB, {});
  ASSERT_GE(best, 0);
  EXPECT_GT(world.at(best).target.left_mps, world.at(best).target.right_mps) << "clockwise is shorter";
}

// Seed 31.
TEST(Rollouts, KeepToTheWheelsLimits) {
  std::mt19937 random(31);
  World world;
  const Pose2 X_WB{10.1, 10.1, 0.3};
  world.set({}, X_WB);
  for (int round = 0; round < 50; ++round) {
    const DriveCommand wheels{uniform_int(random, -130, 130) / 100.0, uniform_int(random, -130, 130) / 100.0};
    world.plan(X_WB, wheels, uniform_int(random, 10, 200) / 100.0);
    for (const Rollout& rollout : world.planner.rollouts()) {
      EXPECT_LE(std::abs(rollout.target.left_mps), kVehicle.max_speed_mps + 1e-12);
      EXPECT_LE(std::abs(rollout.target.right_mps), kVehicle.max_speed_mps + 1e-12);
      // Between two samples no point of the axle can outrun the faster wheel, nor speed up faster than it
      // can.
      const double dt_s = RolloutParams{}.horizon_s / kRolloutSamples;
      Point2 from{X_WB.x_m, X_WB.y_m};
      double speed = std::abs(wheels.left_mps + wheels.right_mps) / 2;
      for (const Point2& p : rollout.points_W) {
        const double now = std::hypot(p.x_m - from.x_m, p.y_m - from.y_m) / dt_s;
        EXPECT_LE(now, kVehicle.max_speed_mps + 1e-9);
        EXPECT_LE(now - speed, kVehicle.max_acceleration_mps2 * dt_s + 1e-9);
        speed = now;
        from = p;
      }
      const DriveCommand next = world.planner.approach(wheels, rollout.target, 0.1);
      EXPECT_LE(std::abs(next.left_mps - wheels.left_mps), 0.15 + 1e-12);
      EXPECT_LE(std::abs(next.right_mps - wheels.right_mps), 0.15 + 1e-12);
    }
  }
}

// Seed 32: a forest around the robot.
TEST(Rollouts, NeverChoosesAnArcThroughLethalCells) {
  std::mt19937 random(32);
  int chosen = 0, collisions = 0;
  for (int round = 0; round < 60; ++round) {
    World world;
    std::vector<CellChange> trees;
    for (int k = 0; k < 60; ++k)
      trees.push_back({{uniform_int(random, 30, 70), uniform_int(random, 30, 70)}, CellCost::lethal});
    const Pose2 X_WB{10.1, 10.1, uniform_int(random, -314, 314) / 100.0};
    world.set(trees, X_WB);
    const int best = world.plan(X_WB, {0.5, 0.5});
    for (const Rollout& rollout : world.planner.rollouts()) collisions += rollout.collides ? 1 : 0;
    if (best < 0) continue;
    ++chosen;
    for (const Point2& p : world.at(best).points_W)
      EXPECT_NE(world.map.cost(kWindow.index(kWindow.cell_at(p.x_m, p.y_m))), kLethalCost);
    EXPECT_FALSE(world.at(best).collides);
    EXPECT_TRUE(std::isfinite(world.at(best).score_m));
  }
  EXPECT_GT(chosen, 10);
  EXPECT_GT(collisions, 100);
}

TEST(Rollouts, SlowsDownBesideObstacles) {
  World world;
  const Pose2 X_WB{5.1, 10.1, 0.0};
  std::vector<CellChange> corridor;
  for (int i = 20; i < 60; ++i)
    for (const int j : {47, 53}) corridor.push_back({{i, j}, CellCost::lethal});
  world.set(corridor, X_WB);
  const int best = world.plan(X_WB, {0.4, 0.4});
  ASSERT_GE(best, 0);
  EXPECT_LE((world.at(best).target.left_mps + world.at(best).target.right_mps) / 2,
            RolloutParams{}.slow_mps + 1e-9);
}

TEST(Rollouts, WalledInThereIsNoneToDrive) {
  World world;
  const Pose2 X_WB{10.1, 10.1, 0.0};
  std::vector<CellChange> box;
  for (int k = 45; k <= 55; ++k)
    for (const int l : {47, 53})
      box.insert(box.end(), {{{k, l}, CellCost::lethal}, {{l + 1, k}, CellCost::lethal}});
  world.set(box, X_WB);
  EXPECT_EQ(world.plan(X_WB, {0.4, 0.4}), -1);
}

TEST(Rollouts, ScoreIsOwnCostPlusCostFromItsEnd) {
  World world;
  RolloutParams plain;
  plain.own_cost_weight = 1.0;
  plain.progress_weight = plain.heading_weight_m_per_rad = plain.change_weight_s = 0.0;
  world.planner = RolloutPlanner(plain, kVehicle);
  const Pose2 X_WB{5.1, 10.1, 0.0};
  world.set({}, X_WB);
  world.plan(X_WB, {1.0, 1.0});
  const Rollout& straight = world.at(7);  // the middle one of 15
  EXPECT_NEAR(straight.own_cost_m, 2.0, 1e-9);
  EXPECT_NEAR(straight.score_m, 2.0 + (16.1 - 7.1), 0.02);
}

}  // namespace
}  // namespace hindsight
