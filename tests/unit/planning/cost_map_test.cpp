// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "planning/cost_map.h"

#include <gtest/gtest.h>

#include "tests/unit/planning/grid_support.h"

namespace hindsight {
namespace {

constexpr int kSide = 40;
const GridWindow kWindow{{-20, 7}, kSide, 0.2};

Cell window_cell(int x, int y) { return {kWindow.origin.i + x, kWindow.origin.j + y}; }

CostMap make_map() { return {CostMapParams{}, VehicleParams{}, kSide, 0.2}; }

TEST(CostMap, GrowsAnObstacleByTheHalfWidthWithAMarginAround) {
  CostMap map = make_map();
  const CellChange change{window_cell(20, 20), CellCost::lethal};
  map.update(kWindow, {&change, 1}, {});
  const auto cost = [&](int dx) { return map.cost(20 * kSide + 20 + dx); };
  EXPECT_EQ(cost(0), kLethalCost);
  EXPECT_EQ(cost(2), kLethalCost);  // 0.4 m: half of the vehicle's 0.8 m
  EXPECT_EQ(cost(3), CostMapParams{}.margin_inner_cost);
  EXPECT_EQ(cost(4), CostMapParams{}.margin_outer_cost);
  EXPECT_EQ(cost(5), kFreeCost);
  EXPECT_TRUE(map.obstacle(20 * kSide + 20));
  EXPECT_FALSE(map.obstacle(20 * kSide + 21));
}

TEST(CostMap, HighGroundCostsWhereTheVehicleWouldTouchIt) {
  CostMap map = make_map();
  const CellChange change{window_cell(20, 20), CellCost::high};
  map.update(kWindow, {&change, 1}, {});
  EXPECT_EQ(map.cost(20 * kSide + 22), CostMapParams{}.high_cost);
  EXPECT_EQ(map.cost(20 * kSide + 23), kFreeCost);
}

TEST(CostMap, ReportsEachChangedCellOnceAndNothingForNothing) {
  CostMap map = make_map();
  const CellChange twice[] = {{window_cell(5, 5), CellCost::lethal}, {window_cell(6, 5), CellCost::lethal}};
  std::vector<int> cells;
  for (const CostChange& change : map.update(kWindow, twice, {})) cells.push_back(change.cell);
  std::sort(cells.begin(), cells.end());
  EXPECT_FALSE(cells.empty());
  EXPECT_EQ(std::adjacent_find(cells.begin(), cells.end()), cells.end());
  EXPECT_TRUE(map.update(kWindow, twice, {}).empty());
}

TEST(CostMap, IgnoresCellsOutsideTheWindow) {
  CostMap map = make_map();
  const CellChange outside[] = {{window_cell(-1, 5), CellCost::lethal},
                                {window_cell(5, kSide), CellCost::lethal}};
  EXPECT_TRUE(map.update(kWindow, outside, {}).empty());
}

TEST(CostMap, LetsAVehicleOutOfAGrownObstacleButNotThroughTheObstacle) {
  CostMap map = make_map();
  const CellChange change{window_cell(20, 20), CellCost::lethal};
  const int body[] = {20 * kSide + 22, 20 * kSide + 24};
  map.update(kWindow, {&change, 1}, body);
  EXPECT_EQ(map.cost(20 * kSide + 22), kHighestCost);
  EXPECT_EQ(map.cost(20 * kSide + 21), kHighestCost);
  EXPECT_EQ(map.cost(20 * kSide + 20), kLethalCost);
  const int clear[] = {20 * kSide + 26};
  map.update(kWindow, {}, clear);
  EXPECT_EQ(map.cost(20 * kSide + 22), kLethalCost) << "closed again once the vehicle is out";
  const int on_it[] = {20 * kSide + 20};
  map.update(kWindow, {}, on_it);
  EXPECT_EQ(map.cost(20 * kSide + 20), kHighestCost) << "the cell it stands on cannot be impassable";
}

// Seed 21. The returned changes, applied to a copy, and the incremental map, must equal a map rebuilt each
// time.
TEST(CostMap, IncrementalEqualsRebuilt) {
  std::mt19937 random(21);
  CostMap map = make_map(), rebuilt = make_map();
  std::vector<CellCost> ground(kSide * kSide, CellCost::none);
  std::vector<TraversalCost> mirror(map.costs().begin(), map.costs().end());
  for (int round = 0; round < 300; ++round) {
    std::vector<CellChange> changes;
    for (int k = uniform_int(random, 0, 30); k > 0; --k) {
      const int x = uniform_int(random, 0, kSide - 1), y = uniform_int(random, 0, kSide - 1);
      const auto cost = static_cast<CellCost>(uniform_int(random, 0, 9) == 0 ? 2 : uniform_int(random, 0, 1));
      ground[static_cast<std::size_t>(y * kSide + x)] = cost;
      changes.push_back({window_cell(x, y), cost});
    }
    const int body[] = {uniform_int(random, 0, kSide * kSide - 1), uniform_int(random, 0, kSide * kSide - 1)};
    for (const CostChange& change : map.update(kWindow, changes, body))
      mirror[static_cast<std::size_t>(change.cell)] = change.cost;
    rebuilt.rebuild(ground, body);
    ASSERT_TRUE(std::equal(mirror.begin(), mirror.end(), rebuilt.costs().begin())) << "round " << round;
    ASSERT_TRUE(std::equal(mirror.begin(), mirror.end(), map.costs().begin())) << "round " << round;
  }
}

}  // namespace
}  // namespace hindsight
