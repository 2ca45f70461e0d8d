// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/track_alignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hindsight {
namespace {

TEST(TrackAlignment, FindsTheMotionBetweenExactTracks) {
  const Pose2 X_WE{3.0, -7.0, 2.1};
  TrackAlignment track;
  for (int i = 0; i < 20; ++i) {
    const Point2 p_E_m{500000.0 + i, 0.1 * i * i};  // far off: nothing may cancel
    track.add(X_WE * p_E_m, p_E_m, 1.0);
  }
  EXPECT_NEAR(track.X_WE().heading_rad, 2.1, 1e-9);
  const Point2 p = track.X_WE() * Point2{500010.0, 10.0}, expected = X_WE * Point2{500010.0, 10.0};
  EXPECT_NEAR(p.x_m, expected.x_m, 1e-6);
  EXPECT_NEAR(p.y_m, expected.y_m, 1e-6);
  EXPECT_NEAR(track.reduced_chi_square(), 0.0, 1e-6);
}

TEST(TrackAlignment, GivesNoHeadingAtStandStill) {
  TrackAlignment track;
  EXPECT_TRUE(std::isinf(track.heading_sigma_rad()));
  for (int i = 0; i < 5; ++i) track.add({1.0, 2.0}, {0.1 * i, 0.0}, 1.0);
  EXPECT_TRUE(std::isinf(track.heading_sigma_rad()));
}

TEST(TrackAlignment, DoubtsTheHeadingAsMuchAsItErrs) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 2.0);
  double squared_error = 0.0, chi_square = 0.0, sigma = 0.0;
  constexpr int kRuns = 2000;
  for (int run = 0; run < kRuns; ++run) {
    TrackAlignment track;
    for (int i = 0; i < 25; ++i) track.add({1.0 * i, 0.0}, {1.0 * i + noise(random), noise(random)}, 2.0);
    squared_error += std::pow(track.X_WE().heading_rad, 2) / kRuns;
    chi_square += track.reduced_chi_square() / kRuns;
    sigma = track.heading_sigma_rad();
  }
  EXPECT_NEAR(std::sqrt(squared_error) / sigma, 1.0, 0.1);
  EXPECT_NEAR(chi_square, 1.0, 0.05);
}

}  // namespace
}  // namespace hindsight
