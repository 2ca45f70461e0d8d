// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/exit_code.h"
#include "sim_replay/world/course.h"
#include "sim_replay/world/lane.h"
#include "sim_replay/world/lay_ground.h"
#include "sim_replay/world/obstacle.h"
#include "sim_replay/world/passage.h"
#include "sim_replay/world/random.h"
#include "sim_replay/world/random_streams.h"
#include "sim_replay/world/strewing.h"

namespace hindsight {
namespace {

constexpr int kAttempts = 20;
/// Ground around start and goal that a camera may see.
constexpr double kGroundAround_m = 80.0;
/// A vehicle turns on the spot in less than this.
constexpr double kVehicleReach_m = 0.85;

std::uint32_t draw_look(Random& random) { return static_cast<std::uint32_t>(random.next()); }

class Builder {
 public:
  Builder(const Course& course, std::uint64_t seed)
      : course_(course), seed_(seed), lane_(course.trail, Random(seed, lane_stream)) {}

  World build(std::uint64_t attempt) {
    world_ = {};
    frame();
    lay_ground(course_, lane_, seed_, world_);
    Random random(seed_, objects_stream + (attempt << 8U));
    Strewing strewing(course_, lane_);
    build_fence(strewing);
    build_pocket(strewing, random);
    plant_trees(strewing, random);
    strew_bushes(strewing, random);
    strew_rocks(strewing, random);
    return world_;
  }
  WorldBox strip() const;

 private:
  void frame();
  void build_fence(Strewing& strewing);
  void build_pocket(Strewing& strewing, Random& random);
  void wall(WorldPoint from, WorldPoint to, Strewing& strewing, Random& random);
  void plant_trees(Strewing& strewing, Random& random);
  void strew_bushes(Strewing& strewing, Random& random);
  void strew_rocks(Strewing& strewing, Random& random);
  void plant(WorldPoint at, double radius_m, Random& random);
  double draw_radius_m(const StrewnParams& params, Random& random) const;

  const Course& course_;
  std::uint64_t seed_;
  Lane lane_;
  World world_;
};

void Builder::frame() {
  const CourseParams& strip = course_.course;
  world_.name = strip.name;
  world_.seed = seed_;
  world_.start = lane_.at(course_.start.x_m, course_.start.aside_m);
  world_.start_heading_rad = lane_.heading_rad(course_.start.x_m) + course_.start.heading_rad;
  world_.goal = lane_.at(strip.length_m, course_.goal.aside_m);
  world_.half_size_m = 0.5 * strip.length_m + kGroundAround_m;
  const LightParams& light = course_.light;
  world_.light = {light.sun_azimuth_rad, light.sun_elevation_rad, light.sun_strength, light.haze_range_m,
                  light.cloud_depth};
}

void Builder::build_fence(Strewing& strewing) {
  const FenceParams& params = course_.fence;
  const double length_m = params.left_m + params.right_m;
  if (length_m == 0.0) return;
  const bool mirrored = params.either_side && Random(seed_, fence_stream).chance(0.5);
  const double from_m = mirrored ? -params.left_m : -params.right_m;
  const int spans = std::max(1, static_cast<int>(std::ceil(length_m / params.post_distance_m)));
  Fence fence{{}, params.height_m};
  for (int i = 0; i <= spans; ++i)
    fence.posts.push_back(lane_.at(params.at_m, from_m + length_m * i / spans));
  world_.fences.push_back(fence);
  for (const Obstacle& span : obstacles_of(world_)) strewing.add(span);
}

/// Two sides and a closed end; open towards the start.
void Builder::build_pocket(Strewing& strewing, Random& random) {
  const PocketParams& pocket = course_.pocket;
  if (pocket.depth_m == 0.0) return;
  const double side_m = 0.5 * pocket.width_m;
  const double mouth_m = pocket.at_m - pocket.depth_m;
  wall(lane_.at(mouth_m, side_m), lane_.at(pocket.at_m, side_m), strewing, random);
  wall(lane_.at(pocket.at_m, side_m), lane_.at(pocket.at_m, -side_m), strewing, random);
  wall(lane_.at(pocket.at_m, -side_m), lane_.at(mouth_m, -side_m), strewing, random);
}

/// A row so close that no vehicle fits between its members; without the last one, which begins the next row.
void Builder::wall(WorldPoint from, WorldPoint to, Strewing& strewing, Random& random) {
  const bool bushes = course_.pocket.of == "bushes";
  const double distance_m = bushes ? 0.9 : 0.7;
  const double length_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
  const int members = std::max(1, static_cast<int>(std::lround(length_m / distance_m)));
  for (int i = 0; i < members; ++i) {
    const double part = static_cast<double>(i) / members;
    const WorldPoint at{from.x_m + part * (to.x_m - from.x_m) + random.uniform(-0.1, 0.1),
                        from.y_m + part * (to.y_m - from.y_m) + random.uniform(-0.1, 0.1)};
    const double radius_m = bushes ? random.uniform(0.4, 0.55) : draw_radius_m(course_.trees, random);
    if (bushes) {
      world_.bushes.push_back({at, radius_m, random.uniform(0.8, 1.2), false, draw_look(random)});
    } else {
      plant(at, radius_m, random);
    }
    strewing.add({at, at, radius_m, 0.0, TruthLabel::ground, false});
  }
}

void Builder::plant_trees(Strewing& strewing, Random& random) {
  const TreeParams& params = course_.trees;
  const auto plant_at = [&](WorldPoint at) {
    const double radius_m = draw_radius_m(params, random);
    plant(at, radius_m, random);
    strewing.add({at, at, radius_m, 0.0, TruthLabel::tree, false});
  };
  for (std::size_t i = 0; i + 1 < params.at_m.size(); i += 2) plant_at({params.at_m[i], params.at_m[i + 1]});
  const double part_m = (course_.course.length_m - 2.0 * params.from_m) / std::max(1, params.in_the_way);
  for (int i = 0; i < params.in_the_way; ++i) {
    const double x_m = params.from_m + part_m * (i + random.uniform(0.2, 0.8));
    plant_at(lane_.at(x_m, random.uniform(-0.5, 0.5)));
  }
  const int count = strewing.count(params);
  for (int i = 0; i < count; ++i) {
    const double radius_m = draw_radius_m(params, random);
    plant(strewing.place(params, radius_m, "trees", random), radius_m, random);
  }
}

void Builder::plant(WorldPoint at, double radius_m, Random& random) {
  Tree tree{.at = at, .radius_m = radius_m};
  tree.height_m = random.uniform(course_.trees.height_min_m, course_.trees.height_max_m);
  tree.crown_base_m = tree.height_m * random.uniform(0.3, 0.45);
  tree.crown_radius_m = std::clamp(8.0 * radius_m, 0.7, 2.2) * random.uniform(0.8, 1.2);
  tree.look = draw_look(random);
  world_.trees.push_back(tree);
}

void Builder::strew_bushes(Strewing& strewing, Random& random) {
  const BushParams& params = course_.bushes;
  const int count = strewing.count(params);
  for (int i = 0; i < count; ++i) {
    Bush bush;
    bush.radius_m = draw_radius_m(params, random);
    bush.at = strewing.place(params, bush.radius_m, "bushes", random);
    bush.height_m = random.uniform(params.height_min_m, params.height_max_m);
    bush.drivable = random.chance(params.drivable);
    bush.look = draw_look(random);
    world_.bushes.push_back(bush);
  }
}

void Builder::strew_rocks(Strewing& strewing, Random& random) {
  const RockParams& params = course_.rocks;
  const int count = strewing.count(params);
  for (int i = 0; i < count; ++i) {
    Rock rock;
    rock.radius_m = draw_radius_m(params, random);
    rock.at = strewing.place(params, rock.radius_m, "rocks", random);
    rock.height_m = random.uniform(params.height_min_m, params.height_max_m);
    rock.look = draw_look(random);
    world_.rocks.push_back(rock);
  }
}

double Builder::draw_radius_m(const StrewnParams& params, Random& random) const {
  return random.uniform(params.radius_min_m, params.radius_max_m);
}

/// Where objects stand, and the way must lead: not around the outside. Holds start and goal wherever they
/// are.
WorldBox Builder::strip() const {
  constexpr double kMargin_m = 3.0;
  const double half_m = 0.5 * course_.course.width_m;
  const WorldPoint &start = world_.start, &goal = world_.goal;
  WorldBox box{{std::min(start.x_m, goal.x_m) - kMargin_m, std::min(start.y_m, goal.y_m) - kMargin_m},
               {std::max(start.x_m, goal.x_m) + kMargin_m, std::max(start.y_m, goal.y_m) + kMargin_m}};
  for (double x_m = box.least.x_m; x_m <= box.most.x_m; x_m += 1.0) {
    box.least.y_m = std::min(box.least.y_m, lane_.y_m(x_m) - half_m);
    box.most.y_m = std::max(box.most.y_m, lane_.y_m(x_m) + half_m);
  }
  return box;
}

void expect_free(const Course& course, const World& world, const char* what, WorldPoint p) {
  for (const Obstacle& obstacle : obstacles_of(world)) {
    if (distance_m(obstacle, p) >= kVehicleReach_m) continue;
    throw FatalError(
        kExitConfiguration,
        fmt::format("{}: {} ({:.1f}, {:.1f}) m lies in or within {} m of a {} at ({:.1f}, {:.1f}) m",
                    course.file, what, p.x_m, p.y_m, kVehicleReach_m, name_of(obstacle.label), obstacle.a.x_m,
                    obstacle.a.y_m));
  }
}

}  // namespace

World build_world(const Course& course, std::uint64_t seed) {
  Builder builder(course, seed);
  for (std::uint64_t attempt = 0; attempt < kAttempts; ++attempt) {
    World world = builder.build(attempt);
    expect_free(course, world, "the start", world.start);
    expect_free(course, world, "the goal", world.goal);
    if (is_passable(world, builder.strip(), course.course.least_gap_m)) return world;
  }
  throw FatalError(
      kExitConfiguration,
      fmt::format("{}: no way {} m wide from start to goal in {} drawings (seed {}); expected fewer "
                  "objects or a narrower course.least_gap_m",
                  course.file, course.course.least_gap_m, kAttempts, seed));
}

}  // namespace hindsight
