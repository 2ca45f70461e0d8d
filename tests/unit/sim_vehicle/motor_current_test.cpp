// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/vehicle/motor_current.h"

#include <gtest/gtest.h>

#include <cmath>

#include "perception/slip_detector.h"
#include "test_drive.h"

namespace hindsight {
namespace {

constexpr double kCurrentRate_hz = 50.0;

/// Drives in a straight line and has the project's own detector listen.
class SlipListener {
 public:
  explicit SlipListener(const World& world, std::uint64_t seed) : drive_(world, seed) {}

  const SlipReport& step(double left_mps, double right_mps) {
    drive_.step(WheelCommand{left_mps, right_mps});
    const VehicleSignals& signals = drive_.signals();
    detector_.add_current(hindsight::Wheel::left, signals.currents_stamp, signals.left_a);
    detector_.add_current(hindsight::Wheel::right, signals.currents_stamp, signals.right_a);
    return detector_.update(drive_.now,
                            {WheelMotion{left_mps, signals.left_mps}, {right_mps, signals.right_mps}});
  }
  const SimVehicle& vehicle() const { return drive_.vehicle; }

 private:
  TestDrive drive_;
  SlipDetector detector_{{}, kCurrentRate_hz};
};

/// From 3 s on, when the window holds nothing else; noise may cover the swing now and then.
TEST(MotorCurrents, SwingNear3HzWhereWheelsSlip) {
  constexpr int kSeeds = 20, kSteps = 1000, kFrom = 300;
  int told = 0, above = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SlipListener listener(flat_world(Ground::mud), seed);
    for (int i = 0; i < kSteps; ++i) {
      const SlipReport& report = listener.step(1.0, 1.0);
      if (i < kFrom) continue;
      EXPECT_TRUE(listener.vehicle().slipping());
      told += report.slipping ? 1 : 0;
      for (const WheelSlip& wheel : report.wheels) {
        above += wheel.component > 0.25 && std::abs(wheel.component_hz - 3.0) <= 0.5 ? 1 : 0;
      }
    }
  }
  constexpr int kAll = kSeeds * (kSteps - kFrom);
  EXPECT_GT(told, 0.97 * kAll);
  EXPECT_GT(above, 0.85 * 2 * kAll);
}

/// One hour; the noise is as recorded, so that a rare false alarm belongs to it.
TEST(MotorCurrents, HardlyEverLookLikeSlipOnGrass) {
  SlipListener listener(flat_world(Ground::grass), 4);
  Random random(4);
  WheelCommand command;
  int alarms = 0;
  bool before = false;
  for (int i = 0; i < 60 * 60 * 100; ++i) {
    if (i % 300 == 0) {
      command.left_mps = random.uniform(0.3, 1.2);
      command.right_mps = command.left_mps + random.uniform(-0.2, 0.2);
    }
    const bool told = listener.step(command.left_mps, command.right_mps).slipping;
    alarms += told && !before ? 1 : 0;
    before = told;
  }
  EXPECT_LE(alarms, 1);
}

/// As far from steady as the recordings that the noise was made after: 0.19 to 0.41 of the mean.
TEST(MotorCurrents, AreAsUnsteadyAsRecordedOnes) {
  TestDrive drive(flat_world(Ground::grass), 6);
  drive.drive(0.8, 0.8, 2.0);
  double sum = 0.0, sum2 = 0.0;
  constexpr int kSteps = 3000;
  for (int i = 0; i < kSteps; ++i) {
    drive.step(WheelCommand{0.8, 0.8});
    sum += drive.signals().left_a;
    sum2 += drive.signals().left_a * drive.signals().left_a;
  }
  const double mean_a = sum / kSteps;
  EXPECT_GT(mean_a, 2.0);
  EXPECT_LT(mean_a, 6.0);
  const double unsteadiness = std::sqrt(sum2 / kSteps - mean_a * mean_a) / mean_a;
  EXPECT_GT(unsteadiness, 0.19);
  EXPECT_LT(unsteadiness, 0.41);
}

TEST(MotorCurrents, RiseUphill) {
  World slope = flat_world(Ground::grass);
  slope.terrain.slope_x = 0.1;
  const auto mean_a = [](const World& world) {
    TestDrive drive(world);
    drive.drive(0.6, 0.6, 2.0);
    double sum = 0.0;
    for (int i = 0; i < 1000; ++i) {
      drive.step(WheelCommand{0.6, 0.6});
      sum += drive.signals().left_a / 1000;
    }
    return sum;
  };
  EXPECT_GT(mean_a(slope), 1.5 * mean_a(flat_world(Ground::grass)));
}

}  // namespace
}  // namespace hindsight
