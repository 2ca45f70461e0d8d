// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/wheel_way.h"

#include <gtest/gtest.h>

#include <limits>

namespace hindsight {
namespace {

TEST(WheelWay, IntegratesBetweenSamples) {
  WheelWay way;
  for (int i = 0; i <= 100; ++i) way.add(from_seconds(0.02 * i), {0.02 * i, -0.5});
  const auto rolled_m = way.between(from_seconds(1.0), from_seconds(1.5));
  ASSERT_TRUE(rolled_m);
  EXPECT_NEAR((*rolled_m)[0], 0.5 * (1.5 * 1.5 - 1.0), 1e-3);
  EXPECT_NEAR((*rolled_m)[1], -0.25, 1e-9);
  EXPECT_NEAR((*way.between(from_seconds(1.99), from_seconds(2.05)))[1], -0.03, 1e-9) << "a little on";
}

TEST(WheelWay, SaysNothingOfWhatItDoesNotKnow) {
  WheelWay way;
  EXPECT_FALSE(way.between(from_seconds(0.0), from_seconds(0.1)));
  for (int i = 50; i <= 300; ++i) way.add(from_seconds(0.02 * i), {1.0, 1.0});
  EXPECT_FALSE(way.between(from_seconds(0.9), from_seconds(1.2))) << "forgotten";
  EXPECT_FALSE(way.between(from_seconds(5.9), from_seconds(6.2))) << "not there yet";
  way.add(from_seconds(5.0), {1.0, 1.0});
  way.add(from_seconds(6.1), {std::numeric_limits<double>::quiet_NaN(), 1.0});
  EXPECT_NEAR((*way.between(from_seconds(5.0), from_seconds(6.0)))[0], 1.0, 1e-9)
      << "late and bad ones left out";
  way.add(from_seconds(6.5), {1.0, 1.0});
  EXPECT_FALSE(way.between(from_seconds(5.9), from_seconds(6.5))) << "a gap";
}

}  // namespace
}  // namespace hindsight
