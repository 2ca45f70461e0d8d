// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/ground_slip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>

namespace hindsight {
namespace {

constexpr double kTrackWidth_m = 0.6;

/// A vehicle whose wheels roll at one speed and whose ground goes by as ground_mps(t) has it, at 10 frames a
/// second.
class Drive {
 public:
  explicit Drive(const GroundSlipParams& params = {}) : slip(params, kTrackWidth_m) {}

  /// Returns when slip was first told from now on.
  std::optional<double> run(double end_s, const std::function<double(double)>& ground_mps) {
    std::optional<double> told_s;
    for (; t_s < end_s; t_s += 0.1) {
      for (int i = 0; i < 5; ++i) slip.add_speeds(from_seconds(t_s + 0.02 * i), wheel_mps, wheel_mps);
      const OdometryMotion motion{valid, 0.1 * ground_mps(t_s), 0.1 * yaw_rate_radps, 0.001, 200};
      slip.add_step({from_seconds(t_s - 0.1), from_seconds(t_s), motion});
      const WheelMotion wheel{commanded_mps.value_or(wheel_mps), wheel_mps};
      const GroundSlipReport& report = slip.update(from_seconds(t_s), {wheel, wheel});
      if (report.known && (report.wheels[0].slipping || report.wheels[1].slipping) && !told_s) told_s = t_s;
    }
    return told_s;
  }
  std::optional<double> run(double end_s, double ground_mps) {
    return run(end_s, [=](double) { return ground_mps; });
  }

  GroundSlip slip;
  double t_s = 1.0;
  double wheel_mps = 0.8;
  double yaw_rate_radps = 0.0;
  std::optional<double> commanded_mps;  ///< as the wheels roll
  bool valid = true;
};

TEST(GroundSlip, TellsWheelsThatTurnOnTheSpot) {
  for (const double mps : {1.2, 0.8, 0.3, -0.6}) {
    Drive drive;
    drive.wheel_mps = mps;
    EXPECT_FALSE(drive.run(5.0, mps)) << mps;
    const auto told_s = drive.run(8.0, 0.0);
    ASSERT_TRUE(told_s) << mps;
    EXPECT_LT(*told_s - 5.0, 0.75) << mps;
  }
}

TEST(GroundSlip, TellsASlipOfHalfWithinASecond) {
  Drive drive;
  EXPECT_FALSE(drive.run(5.0, 0.8));
  const auto told_s = drive.run(8.0, 0.4);
  ASSERT_TRUE(told_s);
  EXPECT_LT(*told_s - 5.0, 1.0);
}

TEST(GroundSlip, IsSilentWhileTheGroundIsMeasuredATenthWrong) {
  for (const double scale : {0.85, 1.0, 1.15}) EXPECT_FALSE(Drive().run(120.0, 0.8 * scale)) << scale;
}

TEST(GroundSlip, BearsWheelsThatSpinForAnInstant) {
  EXPECT_FALSE(Drive().run(60.0, [](double t) { return std::fmod(t, 5.0) < 0.25 ? 0.3 : 0.8; }));
}

TEST(GroundSlip, BearsAWayThatSwings) {
  // The chassis pitches at 3 Hz: 0.3 m/s forth and back, nothing in the end.
  EXPECT_FALSE(Drive().run(60.0, [](double t) { return 0.8 + 0.3 * std::sin(2.0 * M_PI * 2.9 * t); }));
}

TEST(GroundSlip, CountsWhatGoesBackwardsAsLost) {
  Drive drive;
  EXPECT_FALSE(drive.run(5.0, 0.8));
  EXPECT_LT(drive.run(8.0, -0.2).value_or(99.0) - 5.0, 0.35);
}

TEST(GroundSlip, TellsWhichWheel) {
  Drive drive;
  drive.yaw_rate_radps = -1.0;  // the right wheel stands on the ground, and turns
  ASSERT_TRUE(drive.run(3.0, 0.5));
  EXPECT_FALSE(drive.slip.report().wheels[0].slipping);
  EXPECT_TRUE(drive.slip.report().wheels[1].slipping);
  EXPECT_NEAR(drive.slip.report().wheels[0].ground_mps, 0.8, 1e-9);
  EXPECT_NEAR(drive.slip.report().wheels[1].ground_mps, 0.2, 1e-9);
  EXPECT_NEAR(drive.slip.report().wheels[1].wheel_mps, 0.8, 1e-9);
}

TEST(GroundSlip, EndsSoonAfterTheWheelsGripAndAtOnceWhereTheyStop) {
  Drive drive;
  ASSERT_TRUE(drive.run(6.0, 0.0));
  drive.run(8.0, 0.8);
  EXPECT_FALSE(drive.slip.report().wheels[0].slipping);
  ASSERT_TRUE(drive.run(9.5, 0.0));
  drive.commanded_mps = 0.0;
  drive.run(9.6, 0.0);
  EXPECT_FALSE(drive.slip.report().wheels[0].slipping);
}

TEST(GroundSlip, KnowsNothingWithoutGround) {
  Drive blind;
  blind.valid = false;
  blind.run(5.0, 0.0);
  EXPECT_FALSE(blind.slip.report().known);
  blind.valid = true;
  blind.run(6.0, 0.8);
  EXPECT_TRUE(blind.slip.report().known);
  blind.valid = false;
  blind.run(6.3, 0.8);
  EXPECT_TRUE(blind.slip.report().known) << "some bad frames";
  blind.run(7.0, 0.8);
  EXPECT_FALSE(blind.slip.report().known);
  GroundSlipParams off;
  off.enabled = false;
  Drive disabled(off);
  EXPECT_FALSE(disabled.run(5.0, 0.0));
  EXPECT_FALSE(disabled.slip.report().known);
}

}  // namespace
}  // namespace hindsight
