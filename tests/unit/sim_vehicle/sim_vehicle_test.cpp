// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/vehicle/sim_vehicle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_replay/world/course.h"
#include "test_drive.h"

namespace hindsight {
namespace {

World course_world(const std::string& name, std::uint64_t seed) {
  return build_world(load_course(HINDSIGHT_SOURCE_DIR "/sim_replay/courses/" + name + ".toml"), seed);
}

World with_tree(double x_m, double y_m) {
  World world = flat_world(Ground::grass);
  world.trees.push_back({.at = {x_m, y_m}, .radius_m = 0.15, .look = 1});
  return world;
}

bool same(const CanFrame& a, const CanFrame& b) {
  return a.stamp == b.stamp && a.id == b.id && a.length == b.length && a.data == b.data;
}

TEST(AVehicle, RepeatsItselfBitForBit) {
  const World world = course_world("forest_bushes", 3);
  TestDrive one(world, 7), other(world, 7), another(world, 8);
  bool differs = false;
  for (int i = 0; i < 3000; ++i) {
    const WheelCommand command{0.8 + 0.4 * std::sin(0.01 * i), 0.8 - 0.4 * std::sin(0.013 * i)};
    one.step(command);
    other.step(command);
    another.step(command);
    ASSERT_TRUE(std::equal(one.heard.can.begin(), one.heard.can.end(), other.heard.can.begin(),
                           other.heard.can.end(), same));
    ASSERT_EQ(one.heard.fixes.size(), other.heard.fixes.size());
    for (std::size_t k = 0; k < one.heard.fixes.size(); ++k) {
      ASSERT_EQ(one.heard.fixes[k].latitude_deg, other.heard.fixes[k].latitude_deg);
    }
    differs = differs || !std::equal(one.heard.can.begin(), one.heard.can.end(), another.heard.can.begin(),
                                     another.heard.can.end(), same);
  }
  EXPECT_EQ(one.vehicle.pose().x_m, other.vehicle.pose().x_m);
  EXPECT_EQ(one.vehicle.pose().pitch_rad, other.vehicle.pose().pitch_rad);
  EXPECT_TRUE(differs);
}

TEST(AVehicle, DrivesStraightAsItsWheelsTurn) {
  for (const Ground ground :
       {Ground::grass, Ground::leaf_litter, Ground::soil, Ground::mulch, Ground::road}) {
    TestDrive drive(flat_world(ground));
    drive.drive(1.0, 1.0, 1.0);
    const double from_m = drive.vehicle.pose().x_m;
    drive.drive(1.0, 1.0, 10.0);
    // Tyres always slip a little under load.
    EXPECT_NEAR(drive.vehicle.pose().x_m - from_m, 10.0, 0.2);
    EXPECT_LT(drive.vehicle.pose().x_m - from_m, 10.0);
    EXPECT_NEAR(drive.vehicle.pose().y_m, 0.0, 1e-6);
    EXPECT_FALSE(drive.vehicle.slipping());
  }
}

TEST(AVehicle, TurnsAsADifferentialDriveDoes) {
  TestDrive drive(flat_world(Ground::grass));
  drive.drive(0.3, 0.7, 3.0);
  EXPECT_NEAR(drive.vehicle.yaw_rate_radps(), 0.4 / VehicleParams{}.track_width_m, 0.03);
  EXPECT_NEAR(drive.signals().yaw_rate_radps, drive.vehicle.yaw_rate_radps(), 0.03);
  TestDrive on_the_spot(flat_world(Ground::grass));
  on_the_spot.drive(-0.3, 0.3, 5.0);
  EXPECT_LT(std::hypot(on_the_spot.vehicle.pose().x_m, on_the_spot.vehicle.pose().y_m), 0.02);
  EXPECT_NEAR(on_the_spot.vehicle.yaw_rate_radps(), 1.0, 0.03);
}

TEST(AVehicle, StopsItsWheelsWhenCommandsStopComing) {
  TestDrive drive(flat_world(Ground::grass));
  drive.drive(1.0, 1.0, 3.0);
  for (int i = 0; i < 9; ++i) drive.step(std::nullopt);
  EXPECT_NEAR(drive.vehicle.speed_mps(), 0.99, 0.02);
  const double from_m = drive.vehicle.distance_m();
  for (int i = 0; i < 150; ++i) drive.step(std::nullopt);
  EXPECT_EQ(drive.vehicle.speed_mps(), 0.0);
  EXPECT_EQ(drive.signals().left_mps, 0.0);
  EXPECT_LT(drive.vehicle.distance_m() - from_m, 0.3);
}

TEST(AVehicle, NeverTurnsItsWheelsFasterThanItMay) {
  TestDrive drive(flat_world(Ground::grass));
  drive.drive(9.0, 9.0, 5.0);
  EXPECT_NEAR(drive.vehicle.speed_mps(), VehicleParams{}.max_speed_mps, 0.03);
}

TEST(AVehicle, StandsWhereItIsToldTo) {
  World world = flat_world(Ground::grass);
  world.terrain.slope_x = 0.1;
  world.terrain.slope_y = 0.05;
  TestDrive drive(world);
  drive.drive(0.0, 0.0, 60.0);
  EXPECT_EQ(drive.vehicle.distance_m(), 0.0);
  EXPECT_NEAR(drive.vehicle.pose().pitch_rad, -std::atan(0.1), 0.03);
  EXPECT_NEAR(drive.vehicle.pose().roll_rad, std::atan(0.05), 0.03);
}

/// Of 1 s and more without a true slip: what is said of it is a false alarm.
TEST(AVehicle, DoesNotSlipOnOrdinaryGround) {
  for (const Ground ground :
       {Ground::grass, Ground::leaf_litter, Ground::soil, Ground::mulch, Ground::gravel}) {
    TestDrive drive(flat_world(ground));
    for (int i = 0; i < 20; ++i) {
      drive.drive(i % 2 == 0 ? 1.2 : 0.3, i % 3 == 0 ? 1.0 : -0.2, 2.0);
      EXPECT_FALSE(drive.vehicle.slipping());
    }
  }
}

TEST(AVehicle, SlipsInMudAndItsWheelsDoNotTell) {
  TestDrive drive(flat_world(Ground::mud));
  drive.drive(1.0, 1.0, 5.0);
  EXPECT_TRUE(drive.vehicle.slipping());
  EXPECT_NEAR(drive.signals().left_mps, 1.0, 0.05);
  EXPECT_LT(drive.vehicle.speed_mps(), 0.5);
  EXPECT_GT(drive.vehicle.speed_mps(), 0.2) << "it must get through";
}

TEST(AVehicle, DoesNotGetUpAMuddySlopeButDownAgain) {
  World world = flat_world(Ground::mud);
  world.terrain.slope_x = 0.12;
  TestDrive drive(world);
  drive.drive(0.8, 0.8, 5.0);
  EXPECT_TRUE(drive.vehicle.slipping());
  EXPECT_LT(drive.vehicle.pose().x_m, 0.5);
  const double from_m = drive.vehicle.pose().x_m;
  drive.drive(-0.5, -0.5, 5.0);
  EXPECT_LT(drive.vehicle.pose().x_m, from_m - 1.0);
}

TEST(ABumper, ClosesOnceAndTheBodyStopsWithinItsTravel) {
  for (const double y_m : {-0.3, 0.0, 0.3}) {
    TestDrive drive(with_tree(3.0, y_m));
    drive.drive(1.0, 1.0, 5.0);
    EXPECT_EQ(drive.vehicle.touches(), 1) << y_m;
    ASSERT_FALSE(drive.edges.empty());
    EXPECT_EQ(drive.edges[0].line, y_m < 0.0 ? Line::bumper_right : Line::bumper_left);
    EXPECT_TRUE(drive.edges[0].active);
    const double front_m =
        drive.vehicle.pose().x_m + VehicleParams{}.front_m * std::cos(drive.vehicle.pose().heading_rad);
    EXPECT_LT(front_m, 3.0 + 0.1) << "not through it";
    drive.drive(-0.5, -0.5, 3.0);
    EXPECT_FALSE(drive.edges.back().active);
    EXPECT_EQ(drive.vehicle.touches(), 1);
  }
  TestDrive head_on(with_tree(3.0, 0.0));
  head_on.drive(0.5, 0.5, 8.0);
  const double front_m = head_on.vehicle.pose().x_m + VehicleParams{}.front_m;
  EXPECT_NEAR(front_m, 3.0 - 0.15 + kBumperTravel_m, 0.002);
  EXPECT_TRUE(head_on.vehicle.collided());
}

TEST(ABody, SlidesAlongWhatItMeetsObliquely) {
  World world = flat_world(Ground::grass);
  world.fences.push_back({{{0.0, -2.5}, {10.0, 2.5}}, 1.2});
  TestDrive drive(world);
  drive.drive(0.8, 0.8, 8.0);
  EXPECT_GE(drive.vehicle.touches(), 1);
  EXPECT_GT(drive.vehicle.distance_m(), 3.0);
  EXPECT_GT(drive.vehicle.pose().heading_rad, 0.1) << "turned along the fence";
}

/// Whatever it is told, it is never inside something rigid.
TEST(ABody, NeverEntersWhatIsRigid) {
  const World world = course_world("forest_bushes", 5);
  TestDrive drive(world, 5);
  Random random(5);
  for (int i = 0; i < 400; ++i) {
    drive.drive(random.uniform(-0.4, 1.2), random.uniform(-0.4, 1.2), 0.5);
    const BodyPose& pose = drive.vehicle.pose();
    for (const Obstacle& obstacle : obstacles_of(world)) {
      if (obstacle.drivable) continue;
      const BodyContact contact =
          body_contact(VehicleParams{}, {pose.x_m, pose.y_m, pose.heading_rad}, obstacle);
      ASSERT_GT(contact.gap_m, -0.01) << "step " << i;
    }
  }
}

TEST(ADrivableBush, SlowsButNeverPressesTheBumper) {
  World world = flat_world(Ground::grass);
  world.bushes.push_back({{3.0, 0.0}, 0.5, 0.8, true, 1});
  TestDrive drive(world);
  drive.drive(0.8, 0.8, 10.0);
  EXPECT_EQ(drive.vehicle.touches(), 0);
  EXPECT_EQ(drive.vehicle.ir_touches(), 1);
  EXPECT_GT(drive.vehicle.pose().x_m, 6.0);
  EXPECT_FALSE(drive.vehicle.collided());
}

TEST(AnIrTouch, IsCountedOnceForEachApproach) {
  TestDrive drive(with_tree(3.0, 0.25));
  drive.drive(0.5, 0.5, 4.4);
  EXPECT_LT(drive.signals().ir_left_m, 0.6);
  EXPECT_EQ(drive.vehicle.ir_touches(), 1);
  drive.drive(0.0, 0.0, 2.0);
  EXPECT_EQ(drive.vehicle.ir_touches(), 1);
  drive.drive(-0.5, -0.5, 3.0);
  EXPECT_EQ(drive.vehicle.ir_touches(), 1);
  drive.drive(0.5, 0.5, 6.0);
  EXPECT_EQ(drive.vehicle.touches(), 1);
  EXPECT_EQ(drive.vehicle.ir_touches(), 1) << "the second approach ended at the bumper";
}

TEST(ABody, PitchesAndRollsOnRoughGround) {
  const World world = course_world("mulch_trail", 2);
  TestDrive drive(world);
  double pitch2 = 0.0, roll2 = 0.0;
  constexpr int kSteps = 500;
  for (int i = 0; i < kSteps; ++i) {
    drive.step(WheelCommand{0.8, 0.8});
    pitch2 += std::pow(drive.vehicle.pose().pitch_rad, 2);
    roll2 += std::pow(drive.vehicle.pose().roll_rad, 2);
  }
  for (const double rms_rad : {std::sqrt(pitch2 / kSteps), std::sqrt(roll2 / kSteps)}) {
    EXPECT_GT(rms_rad, 0.005);
    EXPECT_LT(rms_rad, 0.08);
  }
}

TEST(ABody, HardlyPitchesWhenItMeetsATree) {
  TestDrive drive(with_tree(3.0, 0.0));
  for (int i = 0; i < 400; ++i) {
    drive.step(WheelCommand{1.2, 1.2});
    ASSERT_LT(std::abs(drive.vehicle.pose().pitch_rad), 0.1);
  }
  EXPECT_EQ(drive.vehicle.touches(), 1);
}

TEST(AVehicle, NoticesThatItLeavesTheWorld) {
  World world = flat_world(Ground::road);
  world.goal = {0.0, 0.0};
  world.half_size_m = 3.0;
  TestDrive drive(world);
  drive.drive(1.0, 1.0, 2.0);
  EXPECT_FALSE(drive.vehicle.left_world());
  drive.drive(1.0, 1.0, 3.0);
  EXPECT_TRUE(drive.vehicle.left_world());
}

}  // namespace
}  // namespace hindsight
