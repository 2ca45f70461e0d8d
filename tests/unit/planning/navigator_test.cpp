// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The navigator in closed loop with a kinematic robot on a grid world, part of which is unknown until
// touched.
#include "planning/navigator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>
#include <string>

#include "tests/unit/planning/grid_support.h"

namespace hindsight {
namespace {

constexpr double kResolution_m = 0.2;
constexpr double kDt_s = 0.1;

class ToyWorld {
 public:
  explicit ToyWorld(int window_cells)
      : window_{{0, 0}, window_cells, kResolution_m},
        navigator_(PlanningParams{}, vehicle_, window_cells, kResolution_m) {
    in_.X_WB = {2.1, 2.1, 0.0};
    in_.motion_permitted = true;
    in_.dt_s = kDt_s;
  }

  void add_known(int i, int j) {
    solid_.insert({i, j});
    known_.insert({i, j});
    in_changes_.push_back({{i, j}, CellCost::lethal});
  }
  void remove(int i, int j) {
    solid_.erase({i, j});
    known_.erase({i, j});
    in_changes_.push_back({{i, j}, CellCost::none});
  }
  void add_hidden(int i, int j) { solid_.insert({i, j}); }

  /// One tick; false if the robot's body is where it can never be.
  bool tick() {
    keep_window_around_robot();
    in_.window = &window_;
    in_.changes = in_changes_;
    in_.window_costs = costs_;
    out_ = navigator_.step(in_);
    in_.window_moved = false;
    in_changes_.clear();
    trail_.push_back({in_.X_WB.x_m, in_.X_WB.y_m});
    behaviours_.insert(out_.behaviour);
    move(out_.command);
    in_.now += from_seconds(kDt_s);
    return !axle_in_solid();
  }

  /// Runs until arrived; how many ticks it took, or -1 after `most`.
  int drive_to(Point2 goal_W, int most) {
    in_.goal_W = goal_W;
    for (int k = 0; k < most; ++k) {
      EXPECT_TRUE(tick()) << "inside an obstacle at tick " << k;
      if (out_.reached) return k;
    }
    return -1;
  }

  bool seen(Behaviour behaviour) const { return behaviours_.count(behaviour) != 0; }
  const NavigatorOutput& out() const { return out_; }
  NavigatorInput& in() { return in_; }
  const GridWindow& window() const { return window_; }
  int windows() const { return windows_; }

  /// For a look at the run: a PPM of the world from (0, 0), where HINDSIGHT_PICTURES names a folder.
  void draw(const std::string& name, int width, int height) const {
    const char* folder = std::getenv("HINDSIGHT_PICTURES");
    if (folder == nullptr) return;
    constexpr int kZoom = 6;
    std::vector<unsigned char> rgb(static_cast<std::size_t>(width * height * kZoom * kZoom * 3), 255);
    const auto paint = [&](double x_m, double y_m, int size, int r, int g, int b) {
      const int u0 = static_cast<int>(x_m / kResolution_m * kZoom),
                v0 = static_cast<int>(y_m / kResolution_m * kZoom);
      for (int v = v0; v < v0 + size; ++v) {
        for (int u = u0; u < u0 + size; ++u) {
          if (u < 0 || v < 0 || u >= width * kZoom || v >= height * kZoom) continue;
          unsigned char* p =
              &rgb[static_cast<std::size_t>(((height * kZoom - 1 - v) * width * kZoom + u) * 3)];
          p[0] = static_cast<unsigned char>(r);
          p[1] = static_cast<unsigned char>(g);
          p[2] = static_cast<unsigned char>(b);
        }
      }
    };
    for (const auto& [i, j] : solid_) {
      const bool known = known_.count({i, j}) != 0;
      paint(i * kResolution_m, j * kResolution_m, kZoom, known ? 40 : 200, known ? 40 : 160,
            known ? 40 : 160);
    }
    for (const Point2& p : out_.path_W) paint(p.x_m, p.y_m, 2, 0, 160, 0);
    for (const Point2& p : trail_) paint(p.x_m, p.y_m, 2, 0, 0, 255);
    std::ofstream file(std::string(folder) + "/" + name + ".ppm", std::ios::binary);
    file << "P6\n" << width * kZoom << " " << height * kZoom << "\n255\n";
    file.write(reinterpret_cast<const char*>(rgb.data()), static_cast<std::streamsize>(rgb.size()));
  }

 private:
  void keep_window_around_robot() {
    const Cell robot = window_.cell_at(in_.X_WB.x_m, in_.X_WB.y_m);
    const int half = window_.size_cells / 2, quarter = half / 2;
    const bool inner = std::abs(robot.i - window_.origin.i - half) <= quarter &&
                       std::abs(robot.j - window_.origin.j - half) <= quarter;
    if (inner && windows_ > 0) return;
    ++windows_;
    window_.origin = {robot.i - half, robot.j - half};
    in_.window_moved = true;
    costs_.assign(static_cast<std::size_t>(window_.size_cells * window_.size_cells), CellCost::none);
    for (const auto& [i, j] : known_)
      if (window_.contains({i, j}))
        costs_[static_cast<std::size_t>(window_.index({i, j}))] = CellCost::lethal;
  }

  bool solid_at(const Point2& p_W) const {
    const Cell cell = window_.cell_at(p_W.x_m, p_W.y_m);
    return solid_.count({cell.i, cell.j}) != 0;
  }
  bool axle_in_solid() const { return solid_at({in_.X_WB.x_m, in_.X_WB.y_m}); }

  // The body is stopped where its bumper would enter something solid; what it touches becomes known.
  void move(const DriveCommand& command) {
    EXPECT_LE(std::abs(command.left_mps), vehicle_.max_speed_mps + 1e-9);
    EXPECT_LE(std::abs(command.right_mps), vehicle_.max_speed_mps + 1e-9);
    const double v = (command.left_mps + command.right_mps) / 2;
    const double w = (command.right_mps - command.left_mps) / vehicle_.track_width_m;
    Pose2 next = in_.X_WB;
    next.heading_rad = wrap_angle(next.heading_rad + w * kDt_s);
    next.x_m += v * kDt_s * std::cos(next.heading_rad);
    next.y_m += v * kDt_s * std::sin(next.heading_rad);
    in_.bumper_left = in_.bumper_right = false;
    for (int k = -4; k <= 4; ++k) {
      const Point2 p_W = next * Point2{vehicle_.front_m, 0.1 * k * vehicle_.width_m / 0.8};
      if (!solid_at(p_W)) continue;
      (k >= 0 ? in_.bumper_left : in_.bumper_right) = true;
      const Cell cell = window_.cell_at(p_W.x_m, p_W.y_m);
      if (known_.insert({cell.i, cell.j}).second) in_changes_.push_back({cell, CellCost::lethal});
    }
    const bool touched = in_.bumper_left || in_.bumper_right;
    in_.v_mps = touched && v > 0 ? 0.0 : v;
    in_.yaw_rate_radps = touched && v > 0 ? 0.0 : w;
    if (!touched || v < 0) in_.X_WB = next;
  }

  VehicleParams vehicle_;
  GridWindow window_;
  Navigator navigator_;
  NavigatorInput in_;
  NavigatorOutput out_;
  std::set<std::pair<int, int>> solid_, known_;
  std::vector<CellChange> in_changes_;
  std::vector<CellCost> costs_;
  std::vector<Point2> trail_;
  std::set<Behaviour> behaviours_;
  int windows_ = 0;
};

// Seeds 41 to 46.
TEST(Navigator, DrivesThroughARandomForest) {
  for (unsigned seed = 41; seed <= 46; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    ToyWorld world(200);
    for (int k = 0; k < 70; ++k) {
      const int i = uniform_int(random, 20, 95), j = uniform_int(random, 0, 100);
      for (int t = 0; t < 4; ++t) world.add_known(i + t % 2, j + t / 2);
    }
    EXPECT_GT(world.drive_to({20.0, 18.0}, 1500), 0);
    EXPECT_FALSE(world.seen(Behaviour::stopping)) << "everything was known, so nothing should be touched";
    world.draw("forest" + std::to_string(seed), 110, 110);
  }
}

TEST(Navigator, EscapesACulDeSacThatItFindsByTouch) {
  ToyWorld world(200);
  for (int k = 0; k <= 30; ++k) {  // a U open to the west, its end hidden
    world.add_known(30 + k, 0);
    world.add_known(30 + k, 22);
    if (k <= 22) world.add_hidden(60, k);
  }
  const int ticks = world.drive_to({16.0, 2.3}, 4000);
  world.draw("cul_de_sac", 110, 60);
  EXPECT_GT(ticks, 0);
  EXPECT_TRUE(world.seen(Behaviour::back_up));
  EXPECT_TRUE(world.seen(Behaviour::turn_away));
}

// Seed 47.
TEST(Navigator, FindsItsWayAmongObstaclesKnownByTouchOnly) {
  std::mt19937 random(47);
  ToyWorld world(200);
  for (int k = 0; k < 40; ++k) {
    const int i = uniform_int(random, 20, 85), j = uniform_int(random, 0, 60);
    for (int t = 0; t < 4; ++t) world.add_hidden(i + t % 2, j + t / 2);
  }
  const int ticks = world.drive_to({20.0, 10.0}, 4000);
  world.draw("hidden_forest", 110, 70);
  EXPECT_GT(ticks, 0);
  EXPECT_TRUE(world.seen(Behaviour::back_up));
}

TEST(Navigator, GoalBeyondTheWindowIsReachedWindowByWindow) {
  ToyWorld world(60);
  for (int j = 0; j < 40; ++j) world.add_known(60, j);
  EXPECT_GT(world.drive_to({30.0, 3.0}, 2500), 0);
  EXPECT_GT(world.windows(), 2);
}

TEST(Navigator, StartsInsideAGrownObstacleAndGetsOut) {
  ToyWorld world(100);
  world.add_known(12, 10);  // 0.4 m ahead of the axle
  world.in().goal_W = Point2{8.0, 2.1};
  ASSERT_TRUE(world.tick());
  EXPECT_NE(world.out().behaviour, Behaviour::no_path);
  EXPECT_GT(world.drive_to({8.0, 2.1}, 1500), 0);
}

TEST(Navigator, StandsWithoutGoalPermissionOrPath) {
  ToyWorld world(100);
  ASSERT_TRUE(world.tick());
  EXPECT_EQ(world.out().behaviour, Behaviour::idle);
  EXPECT_EQ(world.out().command, DriveCommand{});
  world.in().goal_W = Point2{8.0, 2.1};
  world.in().motion_permitted = false;
  for (int k = 0; k < 5; ++k) {
    ASSERT_TRUE(world.tick());
    EXPECT_EQ(world.out().behaviour, Behaviour::halted);
    EXPECT_EQ(world.out().command, DriveCommand{});
  }
  world.in().motion_permitted = true;
  ASSERT_TRUE(world.tick());
  EXPECT_EQ(world.out().behaviour, Behaviour::follow);
  EXPECT_NE(world.out().command, DriveCommand{});
  EXPECT_GE(world.out().chosen, 0);
  EXPECT_FALSE(world.out().path_W.empty());
}

TEST(Navigator, SaysThatThereIsNoPathAndGoesOnWhenTheMapChanges) {
  ToyWorld world(100);
  for (int j = -60; j < 60; ++j) world.add_known(25, j);
  world.in().goal_W = Point2{8.0, 2.1};
  world.tick();
  world.tick();
  EXPECT_EQ(world.out().behaviour, Behaviour::no_path);
  EXPECT_EQ(world.out().command, DriveCommand{});
  EXPECT_TRUE(std::isinf(world.out().cost_to_goal));
  EXPECT_TRUE(world.out().path_W.empty());
  for (int j = 5; j < 16; ++j) world.remove(25, j);
  EXPECT_GT(world.drive_to({8.0, 2.1}, 1000), 0);
}

TEST(Navigator, RangeSensorSlowsIt) {
  ToyWorld world(100);
  world.in().goal_W = Point2{9.0, 2.1};
  world.in().ir_left = true;
  for (int k = 0; k < 20; ++k) {
    ASSERT_TRUE(world.tick());
    EXPECT_LE((world.out().command.left_mps + world.out().command.right_mps) / 2,
              RolloutParams{}.slow_mps + 1e-9);
  }
}

TEST(Navigator, TheSameInputsGiveTheSameCommands) {
  ToyWorld a(100), b(100);
  for (ToyWorld* world : {&a, &b}) {
    world->add_hidden(25, 10);
    world->in().goal_W = Point2{9.0, 2.1};
  }
  for (int k = 0; k < 200; ++k) {
    a.tick();
    b.tick();
    ASSERT_EQ(a.out().command, b.out().command) << "tick " << k;
    ASSERT_EQ(a.out().cost_to_goal, b.out().cost_to_goal);
  }
}

}  // namespace
}  // namespace hindsight
