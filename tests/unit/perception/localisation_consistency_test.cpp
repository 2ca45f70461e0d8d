// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Does the covariance tell the truth about the error?
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "localisation_drive.h"

namespace hindsight {
namespace {

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

}  // namespace
}  // namespace hindsight
