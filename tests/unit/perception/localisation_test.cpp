// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/localisation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "localisation_drive.h"

namespace hindsight {
namespace {

TEST(Localisation, WithoutGpsRunsFromWhereItStarted) {
  Drive drive(white(), {0.0, 0.0, 0.0}, 1);
  drive.gps = false;
  drive.stand(20.0);
  drive.straight(50.0);
  const PoseEstimate& e = drive.localisation.estimate();
  EXPECT_FALSE(e.has_global_origin);
  EXPECT_FALSE(drive.localisation.local_of(48.0, 11.0).has_value());
  EXPECT_NEAR(e.X_WB.x_m, drive.X_EB.x_m, 4.0 * std::sqrt(e.covariance(0, 0)));
  EXPECT_NEAR(e.X_WB.y_m, drive.X_EB.y_m, 4.0 * std::sqrt(e.covariance(1, 1)));
  EXPECT_LT(std::sqrt(e.covariance(0, 0)), 1.0);
}

TEST(Localisation, FirstFixLeavesThePoseAsItIs) {
  Drive drive(with_heading(true), {0.0, 0.0, 0.0}, 2);
  drive.gps = false;
  drive.curves(30.0);
  const Pose2 before = drive.localisation.estimate().X_WB;
  EXPECT_TRUE(drive.localisation.correct(drive.fix()).accepted);
  const PoseEstimate& after = drive.localisation.estimate();
  EXPECT_TRUE(after.has_global_origin);
  EXPECT_EQ(after.X_WB.x_m, before.x_m);
  EXPECT_EQ(after.X_WB.y_m, before.y_m);
  EXPECT_EQ(after.X_WB.heading_rad, before.heading_rad);
  EXPECT_DOUBLE_EQ(after.covariance(0, 0), kGpsSigma_m * kGpsSigma_m);
}

TEST(Localisation, FindsItsHeadingByDrivingWithoutAJump) {
  Drive drive(white(), {5.0, 6.0, 2.5}, 3);
  drive.stand(10.0);
  EXPECT_FALSE(drive.localisation.estimate().has_global_origin);
  double worst_step_m = 0.0;
  for (int i = 0; i < 400 && !drive.localisation.estimate().has_global_origin; ++i) {
    const Pose2 before = drive.localisation.estimate().X_WB;
    drive.tick(1.0, 1.0);
    const Pose2 after = drive.localisation.estimate().X_WB;
    worst_step_m = std::max(worst_step_m, std::hypot(after.x_m - before.x_m, after.y_m - before.y_m));
  }
  ASSERT_TRUE(drive.localisation.estimate().has_global_origin);
  EXPECT_LT(worst_step_m, 0.15);  // a tick's way is 0.1 m
  EXPECT_LT(std::abs(drive.error().z()), 0.5);
  drive.curves(100.0);
  EXPECT_LT(std::abs(drive.error().z()), 0.1);
  EXPECT_LT(drive.position_error_m(), 2.5);
}

TEST(Localisation, AnOutlierOnTheFirstTrackDoesNotSpoilTheHeading) {
  Drive drive(white(), {0.0, 0.0, -1.0}, 4);
  drive.straight(5.0);
  drive.jump_m = 60.0;
  drive.straight(2.0);
  drive.jump_m = 0.0;
  drive.straight(40.0);
  ASSERT_TRUE(drive.localisation.estimate().has_global_origin);
  EXPECT_LT(std::abs(drive.error().z()), 0.3);
}

TEST(Localisation, RejectsAJumpAndGoesOn) {
  Drive drive(with_heading(true), {0.0, 0.0, 0.0}, 5);
  drive.curves(60.0);
  drive.jump_m = 40.0;
  const std::uint32_t rejected = drive.localisation.estimate().fixes_rejected;
  drive.curves(5.0);
  EXPECT_EQ(drive.localisation.estimate().fixes_rejected, rejected + 5);
  EXPECT_FALSE(drive.report.accepted);
  EXPECT_GT(drive.report.mahalanobis, 10.0);
  EXPECT_LT(drive.position_error_m(), 3.0);
  drive.jump_m = 0.0;
  drive.curves(5.0);
  EXPECT_TRUE(drive.report.accepted);
  EXPECT_EQ(drive.localisation.estimate().recoveries, 0U);
}

TEST(Localisation, GatePassesNearlyAllGoodFixes) {
  Drive drive(with_heading(true), {0.0, 0.0, 0.0}, 6);
  drive.curves(1000.0);
  EXPECT_LE(drive.localisation.estimate().fixes_rejected, 5U);
  EXPECT_GE(drive.localisation.estimate().fixes_accepted, 995U);
}

TEST(Localisation, RecoversWhenCarriedAway) {
  Drive drive(with_heading(true), {0.0, 0.0, 0.0}, 8);
  drive.curves(60.0);
  drive.X_EB.x_m += 50.0;
  drive.X_EB.heading_rad += 2.0;
  drive.straight(9.95);
  EXPECT_EQ(drive.localisation.estimate().recoveries, 1U);
  drive.curves(60.0);
  EXPECT_LT(drive.position_error_m(), 3.0);
  EXPECT_LT(std::abs(drive.error().z()), 0.15);
}

TEST(Localisation, RecoversAtStandStill) {
  Drive drive(with_heading(true), {0.0, 0.0, 0.0}, 9);
  drive.curves(60.0);
  drive.X_EB.y_m += 50.0;
  drive.stand(10.0);
  EXPECT_EQ(drive.localisation.estimate().recoveries, 1U);
  EXPECT_LT(drive.position_error_m(), 4.0 * kGpsSigma_m);
  EXPECT_GT(drive.localisation.estimate().covariance(2, 2), 0.08);
}

TEST(Localisation, DoesNotFollowRejectedFixesThatDisagree) {
  Drive drive(with_heading(true), {0.0, 0.0, 0.0}, 10);
  drive.curves(60.0);
  for (int i = 0; i < 40; ++i) {
    drive.jump_m = i % 2 == 0 ? 40.0 : -80.0;
    drive.curves(1.0);
  }
  EXPECT_EQ(drive.localisation.estimate().recoveries, 0U);
  EXPECT_LT(drive.position_error_m(), 4.0);
}

double position_doubt_m2(const Drive& drive) {
  return drive.localisation.estimate().covariance.topLeftCorner<2, 2>().trace();
}

TEST(Localisation, DropoutGrowsDoubtAndGpsCutsItAgain) {
  Drive drive(with_heading(true), {0.0, 0.0, 0.0}, 11);
  drive.curves(60.0);
  const double with_gps = position_doubt_m2(drive);
  drive.gps = false;
  drive.curves(120.0);
  const double without = position_doubt_m2(drive);
  EXPECT_GT(without, 1.5 * with_gps);
  EXPECT_LT(drive.position_error_m(), 10.0);
  drive.gps = true;
  drive.curves(30.0);
  EXPECT_LT(position_doubt_m2(drive), without);
}

TEST(Localisation, GyroBiasConvergesStandingAndDriving) {
  Drive standing(white(), {0.0, 0.0, 0.0}, 12);
  standing.stand(10.0);
  EXPECT_NEAR(standing.localisation.estimate().gyro_bias_radps, kBias_radps, 0.002);
  Drive driving(with_heading(true), {0.0, 0.0, 0.0}, 13);
  driving.curves(120.0);
  EXPECT_NEAR(driving.localisation.estimate().gyro_bias_radps, kBias_radps, 0.004);
}

TEST(Localisation, HandTurningDoesNotPassForBias) {
  Drive drive(white(), {0.0, 0.0, 0.0}, 14);
  drive.stand(10.0);
  const double bias = drive.localisation.estimate().gyro_bias_radps;
  for (int i = 0; i < 30; ++i) {
    drive.now += from_seconds(kTick_s);
    drive.localisation.predict(
        {.now = drive.now, .wheels_valid = true, .yaw_rate_radps = 0.5, .gyro_valid = true});
  }
  EXPECT_NEAR(drive.localisation.estimate().gyro_bias_radps, bias, 1e-9);
  EXPECT_NEAR(drive.localisation.estimate().X_WB.heading_rad, 1.5 - 3.0 * bias, 0.02);
}

TEST(Localisation, SlippingWheelsAreDoubted) {
  Drive drive(with_heading(true), {0.0, 0.0, 0.0}, 15);
  drive.curves(60.0);
  drive.stuck = drive.slipping = true;
  drive.straight(20.0);
  EXPECT_EQ(drive.localisation.estimate().recoveries, 0U);
  EXPECT_LT(drive.position_error_m(), 4.0 * std::sqrt(drive.localisation.estimate().covariance(0, 0) +
                                                      drive.localisation.estimate().covariance(1, 1)));
  EXPECT_LT(drive.position_error_m(), 6.0);  // the wheels rolled 20 m
}

TEST(Localisation, StandsWithGrowingDoubtWithoutWheels) {
  Drive drive(white(), {0.0, 0.0, 0.0}, 16);
  drive.gps = drive.wheels = drive.gyro = false;
  drive.straight(4.0);
  const PoseEstimate& e = drive.localisation.estimate();
  EXPECT_EQ(e.X_WB.x_m, 0.0);
  EXPECT_NEAR(e.covariance(0, 0), 0.5 * 0.5 * 4.0, 0.03);
  EXPECT_NEAR(e.covariance(2, 2), 0.5 * 0.5 * 4.0, 0.03);
}

TEST(Localisation, TakesNumbersThatAreNotFiniteForNotValid) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Localisation localisation(LocalisationParams{}, VehicleParams{});
  localisation.predict({.now = Time{0}});
  localisation.predict({.now = from_seconds(0.1),
                        .left_mps = kNan,
                        .wheels_valid = true,
                        .yaw_rate_radps = kNan,
                        .gyro_valid = true});
  EXPECT_TRUE(localisation.estimate().covariance.allFinite());
  EXPECT_EQ(localisation.estimate().X_WB.x_m, 0.0);
}

TEST(Localisation, RejectsUnusableFixes) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Localisation localisation(with_heading(true), VehicleParams{});
  const Time now = from_seconds(100.0);
  EXPECT_FALSE(localisation.correct({.stamp = now, .latitude_deg = 48.0}).accepted);  // no predict() yet
  localisation.predict({.now = now});
  EXPECT_FALSE(localisation.correct({.stamp = now, .latitude_deg = kNan}).accepted);
  EXPECT_FALSE(localisation.correct({.stamp = now, .latitude_deg = 91.0}).accepted);
  EXPECT_FALSE(localisation.correct({.stamp = now, .longitude_deg = kNan}).accepted);
  EXPECT_FALSE(localisation.correct({.stamp = now, .horizontal_sigma_m = kNan}).accepted);
  EXPECT_FALSE(localisation.correct({.stamp = now - from_seconds(2.1)}).accepted);
  EXPECT_FALSE(localisation.correct({.stamp = now + from_seconds(0.1)}).accepted);
  EXPECT_EQ(localisation.estimate().fixes_rejected, 7U);
  EXPECT_FALSE(localisation.estimate().has_global_origin);
  EXPECT_TRUE(localisation.correct({.stamp = now, .latitude_deg = 48.0}).accepted);
}

TEST(Localisation, CarriesAnOldFixForward) {
  LocalisationParams params = with_heading(true);
  params.initial_heading_sigma_rad = 0.0;
  Localisation localisation(params, VehicleParams{});
  for (int i = 0; i <= 20; ++i) {
    localisation.predict(
        {.now = i * from_seconds(0.1), .left_mps = 1.0, .right_mps = 1.0, .wheels_valid = true});
  }
  // Taken at x = 1, told at x = 2: W's origin is 1 m west of the fix.
  ASSERT_TRUE(localisation.correct({.stamp = from_seconds(1.0), .latitude_deg = 48.0, .longitude_deg = 11.0})
                  .accepted);
  EXPECT_NEAR(localisation.local_of(48.0, 11.0)->x_m, 1.0, 1e-6);
  EXPECT_NEAR(localisation.estimate().X_WB.x_m, 2.0, 1e-9);
}

TEST(Localisation, BeginsWithTheBiasThatItIsTold) {
  LocalisationParams params;
  params.initial_gyro_bias_radps = 0.02;
  Localisation localisation(params, VehicleParams{});
  EXPECT_EQ(localisation.estimate().gyro_bias_radps, 0.02);
  for (int i = 0; i < 100; ++i) {
    localisation.predict({.now = from_seconds(1.0 + 0.1 * i), .yaw_rate_radps = 0.02, .gyro_valid = true});
  }
  EXPECT_NEAR(localisation.estimate().X_WB.heading_rad, 0.0, 1e-9);
}

}  // namespace
}  // namespace hindsight
