// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/world/course.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "config/configuration.h"
#include "config/exit_code.h"
#include "sim_replay/world/obstacle.h"
#include "sim_replay/world/passage.h"

namespace hindsight {
namespace {

Course course_from(const std::string& text) { return read_course(ConfigDocument::parse(text, "c.toml")); }

void expect_refusal(const std::string& text, const std::vector<std::string>& parts) {
  try {
    build_world(course_from(text), 1);
    ADD_FAILURE() << "no error";
  } catch (const FatalError& error) {
    EXPECT_EQ(error.code(), kExitConfiguration) << error.what();
    for (const std::string& part : parts) EXPECT_THAT(error.what(), testing::HasSubstr(part));
  }
}

std::vector<std::string> course_files() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(HINDSIGHT_SOURCE_DIR "/sim_replay/courses")) {
    files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool same(const WorldPoint& a, const WorldPoint& b) { return a.x_m == b.x_m && a.y_m == b.y_m; }

bool same(const World& a, const World& b) {
  const std::vector<Obstacle> first = obstacles_of(a), second = obstacles_of(b);
  return first.size() == second.size() && a.patches.size() == b.patches.size() &&
         a.terrain.height_m({3.0, 4.0}) == b.terrain.height_m({3.0, 4.0}) &&
         std::equal(first.begin(), first.end(), second.begin(), [](const Obstacle& x, const Obstacle& y) {
           return same(x.a, y.a) && same(x.b, y.b) && x.radius_m == y.radius_m && x.height_m == y.height_m &&
                  x.drivable == y.drivable;
         });
}

TEST(ACourse, RefusesWhatItDoesNotKnowWithTheLine) {
  expect_refusal("[course]\nlength_m = 30\nlenth_m = 3", {"c.toml:3:", "lenth_m", "length_m"});
  expect_refusal("[forest]\nx = 1", {"c.toml:1:", "[forest]"});
  expect_refusal("[trees]\nper_m2 = \"many\"", {"c.toml:2:", "per_m2", "a number"});
  expect_refusal("[trees]\n\nper_m2 = 7.0", {"c.toml:3:", "per_m2", "0 to 1"});
  expect_refusal("[course]\nground = \"lava\"", {"c.toml:2:", "lava", "grass"});
}

TEST(ACourse, RefusesWhatCannotBe) {
  expect_refusal("[trees]\nradius_min_m = 0.3\nradius_max_m = 0.2", {"c.toml:3:", "radius_max_m", "0.3"});
  expect_refusal("[trees]\nat_m = [1, 2, 3]", {"c.toml:2:", "at_m"});
  expect_refusal("[mud]\nfrom_m = 30\nto_m = 20", {"c.toml:3:", "to_m"});
}

TEST(ACourse, NamesTheTreeThatItsStartLiesIn) {
  expect_refusal("[trees]\nat_m = [0.2, 0.1]", {"c.toml", "start (0.0, 0.0)", "tree at (0.2, 0.1)"});
  expect_refusal("[trees]\nat_m = [70.0, 0.1]", {"c.toml", "goal (70.0, 0.0)", "tree at (70.0, 0.1)"});
}

TEST(ACourse, SaysThatThereIsNoRoom) {
  expect_refusal("[trees]\nper_m2 = 0.5\nspacing_m = 5", {"c.toml", "[trees]", "no room"});
}

TEST(ACourse, SaysThatThereIsNoWay) {
  expect_refusal("[fence]\nat_m = 30\nleft_m = 40\nright_m = 40",
                 {"c.toml", "no way 1.8 m wide", "20 drawings"});
}

TEST(ACourse, ThatIsNotThereIsNoInput) {
  try {
    load_course("/nowhere/at_all.toml");
    ADD_FAILURE() << "no error";
  } catch (const FatalError& error) {
    EXPECT_EQ(error.code(), kExitNoInput);
  }
}

TEST(ACourse, GivesTheSameWorldForTheSameSeedOnly) {
  for (const std::string& file : course_files()) {
    const Course course = load_course(file);
    EXPECT_TRUE(same(build_world(course, 7), build_world(course, 7))) << file;
    EXPECT_FALSE(same(build_world(course, 7), build_world(course, 8))) << file;
  }
}

TEST(ACourse, KeepsItsObjectsWhereverOneStarts) {
  Course course = load_course(HINDSIGHT_SOURCE_DIR "/sim_replay/courses/forest.toml");
  const World middle = build_world(course, 11);
  for (const double aside_m : {-5.0, -2.0, 3.0, 5.0}) {
    course.start.aside_m = aside_m;
    const World world = build_world(course, 11);
    EXPECT_EQ(world.start.y_m, aside_m);
    EXPECT_TRUE(same(world, middle)) << aside_m;
  }
}

TEST(EachCourse, HasAWayForFiftySeeds) {
  for (const std::string& file : course_files()) {
    const Course course = load_course(file);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const World world = build_world(course, seed);
      const WorldBox box{{-20.0, -60.0}, {course.course.length_m + 20.0, 60.0}};
      EXPECT_TRUE(is_passable(world, box, course.course.least_gap_m)) << file << " seed " << seed;
    }
  }
}

TEST(AWorld, IsPassableThroughGapsThatAreWideEnough) {
  World world;
  world.goal = {20.0, 0.0};
  world.fences.push_back({{{10.0, 1.0}, {10.0, 9.0}}, 1.2});
  world.fences.push_back({{{10.0, -1.0}, {10.0, -9.0}}, 1.2});
  const WorldBox box{{-3.0, -5.0}, {23.0, 5.0}};
  EXPECT_TRUE(is_passable(world, box, 1.5));
  EXPECT_FALSE(is_passable(world, box, 2.1));
  world.bushes.push_back({{10.0, 0.0}, 0.5, 0.8, true, 1});
  EXPECT_TRUE(is_passable(world, box, 1.5)) << "through it";
  world.bushes[0].drivable = false;
  EXPECT_FALSE(is_passable(world, box, 1.5));
}

/// Without them, "avoids obstacles" would say nothing.
TEST(TheForest, StandsInTheStraightWay) {
  const Course course = load_course(HINDSIGHT_SOURCE_DIR "/sim_replay/courses/forest.toml");
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const World world = build_world(course, seed);
    EXPECT_GT(world.trees.size(), 100U);
    const auto in_the_way = std::count_if(world.trees.begin(), world.trees.end(), [](const Tree& tree) {
      return tree.at.x_m > 0.0 && tree.at.x_m < 70.0 && std::abs(tree.at.y_m) < tree.radius_m + 0.4;
    });
    EXPECT_GE(in_the_way, 3) << "seed " << seed;
  }
}

TEST(ACourse, ReadsBackAsItIsPrinted) {
  for (const std::string& file : course_files()) {
    Course course = load_course(file);
    EXPECT_TRUE(same(build_world(course_from(print_configuration(course)), 2), build_world(course, 2)))
        << file;
  }
}

TEST(ATrail, IsDense) {
  const Course course = load_course(HINDSIGHT_SOURCE_DIR "/sim_replay/courses/desert_road_winding.toml");
  const std::vector<WorldPoint> centre = build_world(course, 1).trails.at(0).centre;
  for (std::size_t i = 1; i < centre.size(); ++i) {
    EXPECT_LT(std::hypot(centre[i].x_m - centre[i - 1].x_m, centre[i].y_m - centre[i - 1].y_m), 1.0);
  }
}

TEST(ATrail, StaysFreeOfWhatIsRigid) {
  const Course course = load_course(HINDSIGHT_SOURCE_DIR "/sim_replay/courses/mulch_trail.toml");
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const World world = build_world(course, seed);
    for (const Obstacle& obstacle : obstacles_of(world)) {
      for (const WorldPoint& p : world.trails.at(0).centre) EXPECT_GT(distance_m(obstacle, p), 1.2);
    }
  }
}

TEST(AWorld, TellsItsGroundAndItsRise) {
  World world;
  world.trails.push_back({{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}}, 1.0, 0.2, Ground::mulch});
  world.patches.push_back({{2.0, 0.0}, 0.5, Ground::mud});
  EXPECT_EQ(world.ground_at({0.5, 0.49}), Ground::mulch);
  EXPECT_EQ(world.ground_at({0.5, 0.51}), Ground::grass);
  EXPECT_EQ(world.ground_at({1.8, 0.0}), Ground::mud);
  world.terrain = {0.1, -0.05, {{0.3, 0.4, 1.0, 0.2}, {-0.9, 0.1, 2.0, 0.1}}};
  constexpr double kStep_m = 1e-6;
  for (const WorldPoint p : {WorldPoint{0.0, 0.0}, WorldPoint{3.0, -7.0}, WorldPoint{-20.0, 11.0}}) {
    const double here_m = world.terrain.height_m(p);
    const WorldPoint rise = world.terrain.gradient(p);
    EXPECT_NEAR((world.terrain.height_m({p.x_m + kStep_m, p.y_m}) - here_m) / kStep_m, rise.x_m, 1e-6);
    EXPECT_NEAR((world.terrain.height_m({p.x_m, p.y_m + kStep_m}) - here_m) / kStep_m, rise.y_m, 1e-6);
  }
}

}  // namespace
}  // namespace hindsight
