// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/world/passage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim_replay/world/obstacle.h"

namespace hindsight {
namespace {

constexpr double kCell_m = 0.2;

/// Cells that a disc's middle may be in.
class FreeCells {
 public:
  explicit FreeCells(const WorldBox& box)
      : least_(box.least),
        columns_(count(box.most.x_m - box.least.x_m)),
        rows_(count(box.most.y_m - box.least.y_m)),
        free_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 1) {}

  void block(const Obstacle& obstacle, double around_m) {
    const double reach_m = obstacle.radius_m + around_m;
    const int left = std::max(0, column(std::min(obstacle.a.x_m, obstacle.b.x_m) - reach_m));
    const int right = std::min(columns_ - 1, column(std::max(obstacle.a.x_m, obstacle.b.x_m) + reach_m));
    const int bottom = std::max(0, row(std::min(obstacle.a.y_m, obstacle.b.y_m) - reach_m));
    const int top = std::min(rows_ - 1, row(std::max(obstacle.a.y_m, obstacle.b.y_m) + reach_m));
    for (int j = bottom; j <= top; ++j) {
      for (int i = left; i <= right; ++i) {
        if (distance_m(obstacle, middle(i, j)) < around_m) free_[index(i, j)] = 0;
      }
    }
  }

  /// Uses the cells up.
  bool connect(WorldPoint from, WorldPoint to) {
    const std::optional<std::size_t> goal = find(to);
    const std::optional<std::size_t> start = find(from);
    if (!goal || !start) return false;
    std::vector<std::size_t> front{*start};
    while (!front.empty() && free_[*goal] != 0) {
      const std::size_t cell = front.back();
      front.pop_back();
      const auto i = static_cast<int>(cell % static_cast<std::size_t>(columns_));
      const auto j = static_cast<int>(cell / static_cast<std::size_t>(columns_));
      for (const auto& [di, dj] :
           {std::array{1, 0}, std::array{-1, 0}, std::array{0, 1}, std::array{0, -1}}) {
        if (!inside(i + di, j + dj) || free_[index(i + di, j + dj)] == 0) continue;
        free_[index(i + di, j + dj)] = 0;
        front.push_back(index(i + di, j + dj));
      }
    }
    return free_[*goal] == 0;
  }

 private:
  static int count(double length_m) { return std::max(1, static_cast<int>(std::ceil(length_m / kCell_m))); }
  int column(double x_m) const { return static_cast<int>(std::floor((x_m - least_.x_m) / kCell_m)); }
  int row(double y_m) const { return static_cast<int>(std::floor((y_m - least_.y_m) / kCell_m)); }
  bool inside(int i, int j) const { return i >= 0 && j >= 0 && i < columns_ && j < rows_; }
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j * columns_ + i); }
  WorldPoint middle(int i, int j) const {
    return {least_.x_m + (i + 0.5) * kCell_m, least_.y_m + (j + 0.5) * kCell_m};
  }
  /// The point's cell, if it is free.
  std::optional<std::size_t> find(WorldPoint p) const {
    const int i = column(p.x_m), j = row(p.y_m);
    if (!inside(i, j) || free_[index(i, j)] == 0) return std::nullopt;
    return index(i, j);
  }

  WorldPoint least_;
  int columns_;
  int rows_;
  std::vector<std::uint8_t> free_;
};

}  // namespace

bool is_passable(const World& world, const WorldBox& box, double gap_m) {
  FreeCells cells(box);
  for (const Obstacle& obstacle : obstacles_of(world)) {
    if (!obstacle.drivable) cells.block(obstacle, 0.5 * gap_m);
  }
  return cells.connect(world.start, world.goal);
}

}  // namespace hindsight
