// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace hindsight::tools {
namespace {

TEST(SignFlip, EqualsTheExactProbabilityOfFewDifferences) {
  // Of the 2^5 signs, only the two extreme ones have a sum as far from 0: 2 / 32.
  const std::vector<double> all_up{1.0, 2.0, 3.0, 4.0, 5.0};
  EXPECT_NEAR(sign_flip_p_value(all_up, 1), 2.0 / 32.0, 0.003);
  // |1 - 1| = 0: every draw is as far.
  EXPECT_NEAR(sign_flip_p_value(std::vector<double>{1.0, -1.0}, 1), 1.0, 1e-9);
}

TEST(SignFlip, OfManyEqualDifferencesIsSmall) {
  EXPECT_LT(sign_flip_p_value(std::vector<double>(20, 1.0), 2), 1e-4);
}

TEST(Ellipse, HoldsNinetyFivePercentOfANormalDistribution) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<double> x, y;
  for (int i = 0; i < 20000; ++i) {
    const double u = normal(random), v = normal(random);
    x.push_back(10.0 + 3.0 * u);
    y.push_back(2.0 + 2.0 * u + v);
  }
  const Ellipse e = ellipse_95(x, y);
  int inside = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double c = std::cos(e.angle_rad), s = std::sin(e.angle_rad), dx = x[i] - e.x, dy = y[i] - e.y;
    inside += std::hypot((c * dx + s * dy) / e.major, (-s * dx + c * dy) / e.minor) <= 1.0;
  }
  EXPECT_NEAR(inside / 20000.0, 0.95, 0.01);
}

}  // namespace
}  // namespace hindsight::tools
