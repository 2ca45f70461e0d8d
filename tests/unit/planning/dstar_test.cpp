// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "planning/dstar.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/planning/grid_support.h"

namespace hindsight {
namespace {

constexpr Layout kLayouts[] = {Layout::open, Layout::random, Layout::weighted, Layout::rooms, Layout::maze};

TraversalCost random_cost(std::mt19937& random) {
  const int kind = uniform_int(random, 0, 2);
  if (kind == 0) return kLethalCost;
  return kind == 1 ? kFreeCost : static_cast<TraversalCost>(uniform_int(random, 1, kHighestCost));
}

PathCost length_of(const TestGrid& grid, std::span<const int> path) {
  PathCost sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const int x = path[i] % grid.width, y = path[i] / grid.width;
    const int from_x = path[i - 1] % grid.width, from_y = path[i - 1] / grid.width;
    EXPECT_LE(std::abs(x - from_x), 1);
    EXPECT_LE(std::abs(y - from_y), 1);
    EXPECT_TRUE(grid.free(x, y) && grid.free(from_x, y) && grid.free(x, from_y))
        << "corner cut or lethal cell";
    const bool diagonal = x != from_x && y != from_y;
    sum +=
        static_cast<PathCost>((diagonal ? 577 : 408) * (grid.costs[static_cast<std::size_t>(path[i])] +
                                                        grid.costs[static_cast<std::size_t>(path[i - 1])]));
  }
  return sum;
}

// Follows one robot over one map while the map changes, and compares with Dijkstra after every edit.
class Follower {
 public:
  Follower(TestGrid grid, unsigned seed)
      : grid_(std::move(grid)), dstar_(grid_.width, grid_.height), random_(seed) {
    path_.resize(grid_.costs.size());
    dstar_.init(grid_.costs);
    new_goal();
    start_ = uniform_int(random_, 0, grid_.size() - 1);
  }

  void edit() {
    const bool near = uniform_int(random_, 0, 1) == 0;
    const int x =
        near ? start_ % grid_.width + uniform_int(random_, -5, 5) : uniform_int(random_, 0, grid_.width - 1);
    const int y =
        near ? start_ / grid_.width + uniform_int(random_, -5, 5) : uniform_int(random_, 0, grid_.height - 1);
    const int cell = std::clamp(y, 0, grid_.height - 1) * grid_.width + std::clamp(x, 0, grid_.width - 1);
    TraversalCost& cost = grid_.costs[static_cast<std::size_t>(cell)];
    cost = random_cost(random_);
    dstar_.set_cost(cell, cost);
  }

  void move() {
    if (uniform_int(random_, 0, 9) == 0) start_ = uniform_int(random_, 0, grid_.size() - 1);
    const int length = dstar_.extract_path(path_);
    if (length > 1 && uniform_int(random_, 0, 1) == 0) start_ = path_[1];
  }

  void new_goal() {
    seeds_.clear();
    const int count = uniform_int(random_, 0, 3) == 0 ? 5 : 1;
    for (int i = 0; i < count; ++i)
      seeds_.push_back({uniform_int(random_, 0, grid_.size() - 1),
                        count == 1 ? 0 : static_cast<PathCost>(uniform_int(random_, 0, 100000))});
    dstar_.set_goal(seeds_);
  }

  void check() {
    const std::vector<PathCost> truth = dijkstra(grid_, seeds_);
    ASSERT_EQ(dstar_.replan(start_), truth[static_cast<std::size_t>(start_)]);
    repairs_ += dstar_.searched_anew() ? 0 : 1;
    const int length = dstar_.extract_path(path_);
    if (truth[static_cast<std::size_t>(start_)] == kUnreachable) {
      ASSERT_EQ(length, 0);
    } else {
      ASSERT_GE(length, 1);
      const int last = path_[static_cast<std::size_t>(length - 1)];
      ASSERT_EQ(length_of(grid_, {path_.data(), static_cast<std::size_t>(length)}) +
                    truth[static_cast<std::size_t>(last)],
                truth[static_cast<std::size_t>(start_)]);
      ASSERT_TRUE(
          std::any_of(seeds_.begin(), seeds_.end(), [last](const GoalSeed& s) { return s.cell == last; }));
    }
    for (int i = 0; i < 3; ++i) {
      const int cell = uniform_int(random_, 0, grid_.size() - 1);
      ASSERT_EQ(dstar_.cost_to_goal(cell), truth[static_cast<std::size_t>(cell)]) << "cell " << cell;
    }
  }

  int repairs() const { return repairs_; }

 private:
  TestGrid grid_;
  DStar dstar_;
  std::mt19937 random_;
  std::vector<GoalSeed> seeds_;
  std::vector<int> path_;
  int start_ = 0;
  int repairs_ = 0;
};

// 5 layouts x 2000 edits = 10,000; seeds 1 to 5.
TEST(DStar, AgreesWithDijkstraAfterEveryEdit) {
  unsigned seed = 1;
  int repairs = 0;
  for (const Layout layout : kLayouts) {
    std::mt19937 random(seed);
    Follower follower(make_grid(layout, 41, 29, random), seed++);
    for (int i = 0; i < 2000; ++i) {
      SCOPED_TRACE(testing::Message() << "layout " << static_cast<int>(layout) << " edit " << i);
      follower.edit();
      if (i % 3 == 0) follower.move();
      if (i % 100 == 99) follower.new_goal();
      follower.check();
      if (HasFatalFailure()) return;
    }
    repairs += follower.repairs();
  }
  EXPECT_GT(repairs, 2000) << "the repair must have been tried, not only the search from nothing";
}

// Seeds 11 to 15.
TEST(DStar, AgreesWithDijkstraAfterBatchesOfEdits) {
  unsigned seed = 11;
  for (const Layout layout : kLayouts) {
    std::mt19937 random(seed);
    Follower follower(make_grid(layout, 60, 60, random), seed++);
    for (int i = 0; i < 60; ++i) {
      for (int k = uniform_int(random, 0, 3) == 0 ? 2000 : 40; k > 0; --k) follower.edit();
      follower.move();
      follower.check();
      if (HasFatalFailure()) return;
    }
  }
}

TEST(DStar, StraightAndDiagonalLengths) {
  DStar dstar(10, 10);
  dstar.set_goal(0);
  EXPECT_EQ(dstar.replan(9), 9 * kCellUnit);
  EXPECT_EQ(dstar.replan(99), 9 * 1154U);
  EXPECT_EQ(dstar.replan(0), 0U);
}

TEST(DStar, DoesNotCutCorners) {
  DStar dstar(2, 2);
  dstar.set_goal(3);
  EXPECT_EQ(dstar.replan(0), 1154U);
  dstar.set_cost(1, kLethalCost);
  EXPECT_EQ(dstar.replan(0), 2 * kCellUnit);
  dstar.set_cost(2, kLethalCost);
  EXPECT_EQ(dstar.replan(0), kUnreachable);
  dstar.set_cost(1, kFreeCost);
  dstar.set_cost(2, kFreeCost);
  EXPECT_EQ(dstar.replan(0), 1154U);
}

TEST(DStar, CostIsLengthTimesMeanOfBothCells) {
  DStar dstar(3, 1);
  dstar.init(std::vector<TraversalCost>{1, 11, 3});
  dstar.set_goal(2);
  EXPECT_EQ(dstar.replan(0), (1 + 11) * kCellUnit / 2 + (11 + 3) * kCellUnit / 2);
}

TEST(DStar, LethalStartOrGoalIsUnreachableUntilFreed) {
  DStar dstar(8, 8);
  dstar.set_goal(63);
  dstar.set_cost(63, kLethalCost);
  EXPECT_EQ(dstar.replan(0), kUnreachable);
  std::vector<int> path(64);
  EXPECT_EQ(dstar.extract_path(path), 0);
  dstar.set_cost(63, 2);
  dstar.set_cost(0, kLethalCost);
  EXPECT_EQ(dstar.replan(0), kUnreachable);
  EXPECT_LT(dstar.replan(1), kUnreachable);
  dstar.set_cost(0, 2);
  EXPECT_LT(dstar.replan(0), kUnreachable);
}

TEST(DStar, WithoutGoalNothingIsReachable) {
  DStar dstar(5, 5);
  EXPECT_EQ(dstar.replan(0), kUnreachable);
  EXPECT_EQ(dstar.cost_to_goal(7), kUnreachable);
}

TEST(DStar, SeedsFarApartInCostAreAllWeighed) {
  DStar dstar(100, 1);
  const GoalSeed seeds[] = {{0, 3'000'000}, {99, 1'000}, {50, 2'000'000}};
  dstar.set_goal(seeds);
  EXPECT_EQ(dstar.replan(1), 98 * kCellUnit + 1'000);
  dstar.set_cost(70, kLethalCost);
  EXPECT_EQ(dstar.replan(1), 49 * kCellUnit + 2'000'000);
  dstar.set_cost(20, kLethalCost);
  EXPECT_EQ(dstar.replan(1), kCellUnit + 3'000'000);
}

TEST(DStar, PathStopsWhereTheBufferEnds) {
  DStar dstar(50, 1);
  dstar.set_goal(49);
  dstar.replan(0);
  std::vector<int> path(4);
  EXPECT_EQ(dstar.extract_path(path), 4);
  EXPECT_EQ(path, (std::vector<int>{0, 1, 2, 3}));
}

TEST(DStar, SmallRepairsAreNotSearchedAnew) {
  std::mt19937 random(3);
  TestGrid grid(200, 200);
  for (TraversalCost& cost : grid.costs) cost = static_cast<TraversalCost>(uniform_int(random, 1, 20));
  DStar dstar(200, 200);
  dstar.init(grid.costs);
  dstar.set_goal(199 * 200 + 199);
  dstar.replan(0);
  EXPECT_TRUE(dstar.searched_anew());
  const int whole = dstar.expansions();
  dstar.set_cost(403, kLethalCost);
  dstar.replan(1);
  EXPECT_FALSE(dstar.searched_anew());
  EXPECT_LT(dstar.expansions(), whole / 10);
}

}  // namespace
}  // namespace hindsight
