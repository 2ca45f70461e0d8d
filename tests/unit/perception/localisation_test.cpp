// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/localisation.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <GeographicLib/LocalCartesian.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace hindsight {
namespace {

using Eigen::Vector3d;

constexpr double kTick_s = 0.1;
constexpr double kGpsSigma_m = 1.5;
constexpr double kBias_radps = 0.015;

/// Fixes whose errors do not last.
LocalisationParams white() {
  LocalisationParams params;
  params.gps_correlation_s = 0.0;
  return params;
}
LocalisationParams with_heading(bool known) {
  LocalisationParams params = white();
  params.heading_known = known;
  return params;
}

/// A vehicle in E (east-north about 48 N 11 E) with the filter's own noise model, and the filter that follows
/// it.
class Drive {
 public:
  Drive(const LocalisationParams& params, const Pose2& start, unsigned seed)
      : localisation(params, VehicleParams{}), X_EB(start), params_(params), random_(seed) {}

  /// One tick at the wheel speeds given; every tenth tick brings a fix.
  void tick(double left_mps, double right_mps) {
    const double track_m = VehicleParams{}.track_width_m;
    const double v = 0.5 * (left_mps + right_mps), w = (right_mps - left_mps) / track_m;
    const double lateral_m = params_.lateral_noise_m * std::sqrt(std::abs(v) * kTick_s) * normal();
    if (!stuck) move({v * kTick_s, lateral_m, w * kTick_s});
    now += from_seconds(kTick_s);
    OdometryInput input{.now = now, .wheels_valid = wheels, .slipping = slipping, .gyro_valid = gyro};
    input.left_mps = left_mps + wheel_noise(left_mps);
    input.right_mps = right_mps + wheel_noise(right_mps);
    input.yaw_rate_radps =
        (stuck ? 0.0 : w) + kBias_radps + params_.gyro_noise_radps / std::sqrt(kTick_s) * normal();
    localisation.predict(input);
    if (gps && ++ticks_ % 10 == 0) report = localisation.correct(fix());
  }

  void curves(double seconds) {
    for (double t = 0.0; t < seconds; t += kTick_s) {
      phase_ += kTick_s;
      const double turn_mps = 0.15 * std::sin(0.2 * phase_) + 0.02;
      tick(1.0 - turn_mps, 1.0 + turn_mps);
    }
  }
  void straight(double seconds) {
    for (double t = 0.0; t < seconds; t += kTick_s) tick(1.0, 1.0);
  }
  void stand(double seconds) {
    for (double t = 0.0; t < seconds; t += kTick_s) tick(0.0, 0.0);
  }

  GpsFix fix() {
    GpsFix fix = true_fix();
    double up = 0.0;
    wander();
    earth_.Reverse(X_EB.x_m + jump_m + offset_m_.x_m, X_EB.y_m + offset_m_.y_m, 0.0, fix.latitude_deg,
                   fix.longitude_deg, up);
    return fix;
  }
  GpsFix true_fix() const {
    GpsFix fix{.stamp = now, .altitude_m = 500.0, .horizontal_sigma_m = kGpsSigma_m};
    double up = 0.0;
    earth_.Reverse(X_EB.x_m, X_EB.y_m, 0.0, fix.latitude_deg, fix.longitude_deg, up);
    return fix;
  }

  /// Estimate less truth, once W has its place on the earth.
  Vector3d error() const {
    const GpsFix at = true_fix();
    const Point2 p_W_m = localisation.local_of(at.latitude_deg, at.longitude_deg).value();
    const PoseEstimate& e = localisation.estimate();
    return {e.X_WB.x_m - p_W_m.x_m, e.X_WB.y_m - p_W_m.y_m,
            wrap_angle(e.X_WB.heading_rad - e.heading_WE_rad - X_EB.heading_rad)};
  }
  double nees() const {
    const Vector3d e = error();
    return e.dot(localisation.estimate().covariance.inverse() * e);
  }
  double position_error_m() const { return error().head<2>().norm(); }

  Localisation localisation;
  Pose2 X_EB;
  Time now{};
  bool gps = true, gyro = true, wheels = true, slipping = false, stuck = false;
  double jump_m = 0.0;  ///< by which fixes are off, eastwards
  Localisation::FixReport report;

 private:
  double normal() { return normal_(random_); }
  /// The error of a fix a second after the last: Gauss-Markov, or white.
  void wander() {
    const double kept = params_.gps_correlation_s > 0.0 ? std::exp(-1.0 / params_.gps_correlation_s) : 0.0;
    const double sigma_m = kGpsSigma_m * std::sqrt(1.0 - kept * kept);
    const bool first = std::exchange(wandered_, true) == false;
    offset_m_.x_m = first ? kGpsSigma_m * normal() : kept * offset_m_.x_m + sigma_m * normal();
    offset_m_.y_m = first ? kGpsSigma_m * normal() : kept * offset_m_.y_m + sigma_m * normal();
  }
  double wheel_noise(double speed_mps) {
    return params_.wheel_noise_m * std::sqrt(std::abs(speed_mps) / kTick_s) * normal();
  }
  void move(const Vector3d& by) {
    const Pose2 middle{X_EB.x_m, X_EB.y_m, X_EB.heading_rad + 0.5 * by.z()};
    const Point2 p = middle * Point2{by.x(), by.y()};
    X_EB = {p.x_m, p.y_m, wrap_angle(X_EB.heading_rad + by.z())};
  }

  LocalisationParams params_;
  GeographicLib::LocalCartesian earth_{48.0, 11.0, 500.0};
  std::mt19937 random_;
  std::normal_distribution<double> normal_{0.0, 1.0};
  int ticks_ = 0;
  double phase_ = 0.0;
  Point2 offset_m_;  ///< of the fixes
  bool wandered_ = false;
};

/// Mean of the normalised estimation error squared over seeded runs; chi-square says how far from 3 it may
/// be.
double mean_nees(LocalisationParams params, bool gyro, double dropout_s) {
  constexpr int kRuns = 200;
  double sum = 0.0;
  for (unsigned run = 0; run < kRuns; ++run) {
    std::mt19937 random(1000 + run);
    const double doubt = LocalisationParams{}.initial_heading_sigma_rad;
    const double heading = params.heading_known ? std::normal_distribution<double>(0.0, doubt)(random)
                                                : std::uniform_real_distribution<double>(-3.0, 3.0)(random);
    Drive drive(params, {20.0, -30.0, heading}, run);
    drive.gyro = gyro;
    drive.curves(100.0);
    drive.gps = false;
    drive.curves(dropout_s);
    sum += drive.nees();
  }
  return sum / kRuns;
}

// 600 degrees of freedom: the mean of 200 lies in 3 +- 0.57 with 99.9 %.
constexpr double kNees = 3.0, kNeesBound = 0.57;

TEST(Localisation, IsConsistentWithKnownHeading) {
  EXPECT_NEAR(mean_nees(with_heading(true), true, 0.0), kNees, kNeesBound);
}
TEST(Localisation, IsConsistentThroughADropout) {
  EXPECT_NEAR(mean_nees(with_heading(true), true, 60.0), kNees, kNeesBound);
}
TEST(Localisation, IsConsistentWithoutGyro) {
  EXPECT_NEAR(mean_nees(with_heading(true), false, 0.0), kNees, kNeesBound);
}

TEST(Localisation, IsNeverTooSureWithHeadingFromDriving) {
  // The doubt of the driven track is counted whole though fitting it takes up a part: at or below 3.
  const double nees = mean_nees(with_heading(false), true, 0.0);
  EXPECT_LT(nees, kNees + kNeesBound);
  EXPECT_GT(nees, 1.0);
}

// Errors that last are less than what white noise with their low frequencies would be: never too sure.
TEST(Localisation, IsNotTooSureWhereErrorsOfFixesLast) {
  for (const double lasting_s : {10.0, 30.0, 60.0}) {
    LocalisationParams params = with_heading(true);
    params.gps_correlation_s = lasting_s;
    const double nees = mean_nees(params, true, 0.0);
    EXPECT_LT(nees, kNees + kNeesBound) << lasting_s << " s";
    EXPECT_GT(nees, 1.0) << lasting_s << " s";
  }
}

TEST(Localisation, AHeadingFromFixesWhoseErrorsLastTakesLonger) {
  double squares = 0.0;
  for (unsigned run = 0; run < 100; ++run) {
    Drive drive({}, {0.0, 0.0, 0.3}, 100 + run);
    drive.straight(150.0);
    ASSERT_TRUE(drive.localisation.estimate().has_global_origin) << run;
    squares += std::pow(drive.error().z(), 2);
  }
  EXPECT_LT(std::sqrt(squares / 100.0), 0.15);
}

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
