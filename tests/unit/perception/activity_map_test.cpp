// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/activity_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "perception/activity_prior.h"

namespace hindsight {
namespace {

constexpr ActivityMapParams kPixels{.cell = 16.0, .cells = 256, .max_speed = 12.0};

Eigen::Vector2d polar(double speed, double degrees) {
  return speed * Eigen::Vector2d(std::cos(degrees * M_PI / 180.0), std::sin(degrees * M_PI / 180.0));
}

TEST(ActivityMap, CountsWhatMovedWhere) {
  ActivityMap map(kPixels);
  for (int i = 0; i < 7; ++i) map.add({20.0, -40.0}, polar(3.0, 45.0));
  map.add({20.0, -40.0}, polar(3.0, -130.0));
  map.add({1e9, 0.0}, polar(3.0, 0.0));
  map.add({NAN, 0.0}, polar(3.0, 0.0));
  ASSERT_EQ(map.active().size(), 1U);
  EXPECT_EQ(map.total(), 8U);
  EXPECT_EQ(map.counts(0)[activity_bin(map, polar(3.0, 45.0))], 7U);
  EXPECT_EQ(map.lost(), 1U);
}

TEST(ActivityMap, TellsBothWaysOfACellThatIsUsedBothWays) {
  ActivityMap map(kPixels);
  for (int i = 0; i < 30; ++i) map.add({5.0, 5.0}, polar(2.0, 3.0));
  for (int i = 0; i < 20; ++i) map.add({5.0, 5.0}, polar(2.0, 183.0));
  std::array<ActivityMode, 4> modes;
  ASSERT_EQ(find_modes(map, 0, modes), 2U);
  EXPECT_NEAR(modes[0].direction_rad, 5.0 * M_PI / 180.0, 1e-9);
  EXPECT_NEAR(modes[1].direction_rad, 185.0 * M_PI / 180.0, 1e-9);
  EXPECT_NEAR(modes[0].share, 0.6, 1e-9);
  // A mean would say that nothing moves here; the prior knows both ways, and none across.
  ActivityPrior prior(map);
  const double forth = prior.probability({5, 5}, {2, 0}), back = prior.probability({5, 5}, {-2, 0});
  EXPECT_GT(back, 0.3 * forth);
  EXPECT_GT(back, 20.0 * prior.probability({5, 5}, {0, 2}));
  EXPECT_EQ(prior.probability({500, 500}, {2, 0}), 0.0);
}

TEST(ActivityMap, ThePriorLooksThroughTheViewsHomography) {
  ActivityMap map(kPixels);
  for (int i = 0; i < 30; ++i) map.add({100.0, 100.0}, polar(4.0, 90.0));
  ActivityPrior prior(map);
  Eigen::Matrix3d H_G_image;
  H_G_image << 0.0, -2.0, 300.0, 2.0, 0.0, -100.0, 0.0, 0.0, 1.0;  // a quarter turn, twice as large
  prior.look(H_G_image);
  const Point2f p{100.0F, 100.0F};  // seen at (100, 100), lies at (100, 100) of G
  EXPECT_GT(prior.probability(p, {2.0F, 0.0F}), 0.05);
  EXPECT_LT(prior.probability(p, {0.0F, 2.0F}), 1e-6);
  Point2f v;
  ASSERT_TRUE(prior.sample(p, 0.5, v));
  EXPECT_GT(v.x_px, 1.0F);
  EXPECT_LT(std::abs(v.y_px), 1.0F);
}

TEST(ActivityMap, MergesAnotherOfTheSamePlace) {
  ActivityMap a(kPixels), b(kPixels);
  a.add({40.0, 8.0}, polar(2.0, 5.0));
  b.add({8.0, -40.0}, polar(2.0, -85.0));  // the same, seen turned by -90 degrees
  a.merge(b, 0.5 * M_PI, {0.0, 0.0});
  ASSERT_EQ(a.active().size(), 1U);
  EXPECT_EQ(a.total(), 2U);
  std::array<ActivityMode, 2> modes;
  EXPECT_EQ(find_modes(a, 0, modes), 1U);
}

}  // namespace
}  // namespace hindsight
