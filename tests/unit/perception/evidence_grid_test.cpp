// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/evidence_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "config/exit_code.h"
#include "naive_evidence_grid.h"

namespace hindsight {
namespace {

constexpr auto kGood = TerrainClass::good, kBad = TerrainClass::bad, kLethal = TerrainClass::lethal;

EvidenceGridParams small() {
  EvidenceGridParams params;
  params.size_cells = 21;
  params.margin_m = 1.0;
  return params;
}

void look(EvidenceGrid& grid, Cell cell, TerrainClass label, int frames, float weight = 1.0F) {
  for (int k = 0; k < frames; ++k) {
    grid.vote(cell, label, weight);
    grid.settle();
  }
}

TEST(EvidenceGrid, OneFarLookDecidesNothingAFewDo) {
  EvidenceGrid grid(small());
  look(grid, {3, 4}, kLethal, 1, 0.3F);
  EXPECT_EQ(grid.cost({3, 4}), CellCost::none);
  look(grid, {3, 4}, kLethal, 1, 0.3F);
  EXPECT_EQ(grid.cost({3, 4}), CellCost::lethal);
}

TEST(EvidenceGrid, VotesCountOnlyOnceSettled) {
  EvidenceGrid grid(small());
  grid.vote({0, 0}, kBad, 1.0F);
  EXPECT_EQ(grid.cost({0, 0}), CellCost::none);
  grid.settle();
  EXPECT_EQ(grid.cost({0, 0}), CellCost::high);
}

TEST(EvidenceGrid, OneFrameCannotOutvoteMany) {
  EvidenceGrid grid(small());
  look(grid, {0, 0}, kGood, 20);
  look(grid, {0, 0}, kLethal, 1, 1e6F);
  EXPECT_EQ(grid.cost({0, 0}), CellCost::none);
}

TEST(EvidenceGrid, NewEvidenceOverturnsOld) {
  EvidenceGrid grid(small());
  look(grid, {1, 1}, kLethal, 1000);
  EXPECT_EQ(grid.cost({1, 1}), CellCost::lethal);
  int frames = 0;
  while (grid.cost({1, 1}) != CellCost::none && frames < 100) look(grid, {1, 1}, kGood, 1), ++frames;
  EXPECT_GT(frames, 3);
  EXPECT_LT(frames, 20) << "within a few times max_evidence";
  EXPECT_LE(grid.evidence({1, 1}).votes[0] + grid.evidence({1, 1}).votes[2], 8.001F);
}

TEST(EvidenceGrid, CostHasHysteresis) {
  EvidenceGrid grid(small());
  grid.vote({0, 0}, kBad, 1.0F);
  grid.vote({0, 0}, kGood, 0.9F);
  grid.settle();
  EXPECT_EQ(grid.cost({0, 0}), CellCost::high) << "53 % of the votes";
  grid.vote({0, 0}, kGood, 0.4F);
  grid.settle();
  EXPECT_EQ(grid.cost({0, 0}), CellCost::high) << "43 %, above leave_share";
  grid.vote({0, 0}, kGood, 1.0F);
  grid.settle();
  EXPECT_EQ(grid.cost({0, 0}), CellCost::none) << "30 %";
  grid.vote({0, 0}, kBad, 0.6F);
  grid.settle();
  EXPECT_EQ(grid.cost({0, 0}), CellCost::none) << "41 %, below enter_share";
}

TEST(EvidenceGrid, BadAndLethalVotesTogetherMakeHigh) {
  EvidenceGrid grid(small());
  grid.vote({0, 0}, kBad, 0.3F);
  grid.vote({0, 0}, kLethal, 0.3F);
  grid.vote({0, 0}, kGood, 0.4F);
  grid.settle();
  EXPECT_EQ(grid.cost({0, 0}), CellCost::high);
}

TEST(EvidenceGrid, MarksStandAtOnceAndUntilWornOff) {
  EvidenceGrid grid(small());
  grid.mark({2, 0}, CellCost::high, 5.0F);
  EXPECT_EQ(grid.cost({2, 0}), CellCost::high);
  look(grid, {2, 0}, kGood, 4);
  EXPECT_EQ(grid.cost({2, 0}), CellCost::high);
  look(grid, {2, 0}, kGood, 2);
  EXPECT_EQ(grid.cost({2, 0}), CellCost::none);
}

TEST(EvidenceGrid, TouchedStaysLethalWhateverTheCameraSays) {
  EvidenceGrid grid(small());
  grid.mark({2, 0}, CellCost::lethal, EvidenceGrid::kForever);
  look(grid, {2, 0}, kGood, 5000);
  EXPECT_EQ(grid.cost({2, 0}), CellCost::lethal);
  grid.mark({2, 0}, CellCost::high, 1.0F);
  EXPECT_EQ(grid.cost({2, 0}), CellCost::lethal);
}

TEST(EvidenceGrid, DrivenOverGroundClearsWhatTheCameraThought) {
  EvidenceGrid grid(small());
  look(grid, {2, 0}, kBad, 50);
  grid.mark({2, 0}, CellCost::high, 50.0F);
  grid.mark({2, 0}, CellCost::none, 300.0F);
  EXPECT_EQ(grid.cost({2, 0}), CellCost::none);
}

TEST(EvidenceGrid, OutsideIsNone) {
  EvidenceGrid grid(small());
  grid.vote({11, 0}, kLethal, 5.0F);
  grid.mark({0, -11}, CellCost::lethal, EvidenceGrid::kForever);
  grid.settle();
  EXPECT_EQ(grid.cost({11, 0}), CellCost::none);
  EXPECT_EQ(grid.cost({0, -11}), CellCost::none);
  EXPECT_EQ(grid.cost({1 << 30, -(1 << 30)}), CellCost::none);
  EXPECT_TRUE(grid.changes().empty());
}

TEST(EvidenceGrid, VotesInBFallIntoCellsOfW) {
  EvidenceGridParams params;
  EvidenceGrid grid(params);
  const Pose2 X_WB{-3.31, 7.77, 2.1};
  grid.recentre(X_WB);
  std::mt19937 random(5);  // seed 5
  std::uniform_real_distribution<float> coordinate(-20, 20);
  std::vector<GroundVote> votes;
  for (int n = 0; n < 2000; ++n) votes.push_back({coordinate(random), coordinate(random), 1.0F, kBad});
  grid.vote(votes, X_WB);
  grid.settle();
  for (const GroundVote& v : votes) {
    const Point2 p_WP_m = X_WB * Point2{v.x_B_m, v.y_B_m};
    const auto off_border = [](double x) { return std::abs(x / 0.2 - std::round(x / 0.2)) > 1e-3; };
    if (!off_border(p_WP_m.x_m) || !off_border(p_WP_m.y_m)) continue;
    EXPECT_EQ(grid.cost(grid.window().cell_at(p_WP_m.x_m, p_WP_m.y_m)), CellCost::high);
  }
  const std::vector<GroundVote> far{{1000.0F, 0.0F, 1.0F, kBad}, {NAN, 0.0F, 1.0F, kBad}};
  grid.clear_changes();
  grid.vote(far, X_WB);
  grid.settle();
  EXPECT_TRUE(grid.changes().empty());
}

TEST(EvidenceGrid, MovesOnlyNearTheBorderAndKeepsWhatIsStillInside) {
  EvidenceGrid grid(small());
  EXPECT_FALSE(grid.recentre({0.9, -0.9, 0}));
  grid.mark({5, 5}, CellCost::high, 9.0F);
  grid.mark({-9, 0}, CellCost::lethal, 9.0F);
  EXPECT_TRUE(grid.recentre({1.3, 0.1, 0}));
  EXPECT_EQ(grid.window().origin, (Cell{6 - 10, -10}));
  EXPECT_TRUE(grid.changes().empty());
  EXPECT_EQ(grid.cost({5, 5}), CellCost::high);
  EXPECT_EQ(grid.cost({-9, 0}), CellCost::none);
  EXPECT_TRUE(grid.recentre({-1.0, 0.1, 0}));
  EXPECT_EQ(grid.cost({-9, 0}), CellCost::none) << "what left is forgotten";
  EXPECT_EQ(grid.cost({12, 0}), CellCost::none) << "and does not reappear on the other side";
}

TEST(EvidenceGrid, ContradictingParametersAreRefused) {
  const auto code_of = [](const EvidenceGridParams& params) {
    try {
      EvidenceGrid grid(params);
    } catch (const FatalError& error) {
      return int{error.code()};
    }
    return 0;
  };
  EvidenceGridParams margin = small(), share = small(), limit = small();
  margin.margin_m = 2.1;
  share.leave_share = 0.6;
  limit.min_evidence = 8.0;
  EXPECT_EQ(code_of(margin), kExitConfiguration);
  EXPECT_EQ(code_of(share), kExitConfiguration);
  EXPECT_EQ(code_of(limit), kExitConfiguration);
}

TEST(EvidenceGrid, EqualsANaiveMapUnderRandomUse) {
  std::mt19937 random(2026);  // seed 2026
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  EvidenceGridParams params = small();
  params.enter_share = 0.487;  // two limited frames make exact halves, where float and double may differ
  const int n = params.size_cells;
  EvidenceGrid grid(params);
  NaiveGrid naive(params);
  std::vector<CellCost> consumer(static_cast<std::size_t>(n * n), CellCost::none), whole(consumer);
  Pose2 X_WB;
  int moves = 0, changes = 0;
  for (int step = 0; step < 3000; ++step) {
    X_WB.x_m += uniform(-0.5, 0.52);
    X_WB.y_m += uniform(-0.52, 0.5);
    if (grid.recentre(X_WB)) {
      ++moves;
      grid.copy_costs(consumer);
      std::erase_if(naive.entries, [&](const auto& e) {
        return !grid.window().contains({e.first.first, e.first.second});
      });
    }
    for (int k = 0; k < 40; ++k) {
      const Cell cell{grid.window().origin.i + int(random() % unsigned(n + 4)) - 2,
                      grid.window().origin.j + int(random() % unsigned(n))};
      const double weight = uniform(0.01, 3.0), kind = uniform(0, 1);
      const auto cost = static_cast<CellCost>(random() % 3);
      const auto label = static_cast<TerrainClass>(random() % 4);
      const bool inside = grid.window().contains(cell);
      auto* entry = inside ? &naive.entries[{cell.i, cell.j}] : nullptr;
      if (kind < 0.05) {
        grid.mark(cell, cost, static_cast<float>(weight));
        if (inside) naive.mark(*entry, cost, weight);
      } else {
        grid.vote(cell, label, static_cast<float>(weight));
        if (inside && label != TerrainClass::unknown) entry->frame[static_cast<std::size_t>(label)] += weight;
      }
    }
    grid.settle();
    naive.settle();

    std::set<std::pair<int, int>> seen;
    for (const CellChange& change : grid.changes()) {
      ++changes;
      EXPECT_TRUE(seen.insert({change.cell.i, change.cell.j}).second) << "a cell is reported once";
      consumer[static_cast<std::size_t>(grid.window().index(change.cell))] = change.cost;
    }
    if (step % 3 == 0) grid.clear_changes();
    grid.copy_costs(whole);
    ASSERT_EQ(consumer, whole) << "changes are complete, step " << step;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const Cell cell{grid.window().origin.i + i, grid.window().origin.j + j};
        const NaiveGrid::Entry& expected = naive.entries[{cell.i, cell.j}];
        ASSERT_EQ(grid.cost(cell), whole[static_cast<std::size_t>(grid.window().index(cell))]);
        ASSERT_EQ(grid.cost(cell), expected.cost) << "step " << step << " cell " << cell.i << ' ' << cell.j;
        ASSERT_NEAR(grid.evidence(cell).votes[2], expected.votes[2], 1e-3);
      }
    }
  }
  EXPECT_GT(moves, 50);
  EXPECT_GT(changes, 1000);
}

}  // namespace
}  // namespace hindsight
