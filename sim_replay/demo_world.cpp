// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>

#include "sim_replay/demo_random.h"
#include "sim_replay/demo_scene.h"

namespace hindsight {
namespace {

constexpr int kTrees = 25;
constexpr int kInTheWay = 5;
constexpr double kFirstTree_m = 6.0;
constexpr double kHalfWidth_m = 7.0;
/// Between trunks, so that there is a way through.
constexpr double kLeastGap_m = 2.6;
constexpr double kMudRadius_m = 1.3;

bool has_room(const DemoWorld& world, const DemoTree& tree) {
  const double from_mud_m = std::hypot(tree.x_m - world.mud.x_m, tree.y_m - world.mud.y_m);
  if (from_mud_m < world.mud.radius_m + 1.0) return false;
  return std::none_of(world.trees.begin(), world.trees.end(), [&tree](const DemoTree& other) {
    return std::hypot(tree.x_m - other.x_m, tree.y_m - other.y_m) < kLeastGap_m;
  });
}

}  // namespace

DemoWorld make_demo_world(double goal_x_m, std::uint64_t seed) {
  DemoRandom random(seed);
  DemoWorld world;
  world.mud = {0.6 * goal_x_m, random.uniform(-3.0, 3.0), kMudRadius_m};
  const double last_m = goal_x_m - 3.0;
  while (world.trees.size() < kTrees) {
    const auto k = static_cast<double>(world.trees.size());
    const bool in_the_way = k < kInTheWay;
    DemoTree tree;
    // The first ones stand in the middle, at even distances; the first of all where nothing can be known yet.
    tree.x_m = in_the_way ? kFirstTree_m + k * (last_m - kFirstTree_m) / kInTheWay + random.uniform(-0.5, 0.5)
                          : random.uniform(kFirstTree_m - 1.0, last_m);
    tree.y_m = in_the_way ? random.uniform(-0.4, 0.4) : random.uniform(-kHalfWidth_m, kHalfWidth_m);
    tree.radius_m = random.uniform(0.15, 0.26);
    tree.trunk_m = random.uniform(2.6, 3.6);
    tree.crown_m = random.uniform(0.9, 1.5);
    if (in_the_way && world.mud.y_m * world.mud.y_m < 6.0 && std::abs(tree.x_m - world.mud.x_m) < 3.0) {
      world.mud.y_m = std::copysign(3.0, world.mud.y_m);
    }
    if (has_room(world, tree)) world.trees.push_back(tree);
  }
  return world;
}

}  // namespace hindsight
