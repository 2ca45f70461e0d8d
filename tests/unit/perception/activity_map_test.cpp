// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/activity_map.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "perception/activity_learner.h"
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

TEST(ActivityMap, KnowsHowLongItLookedWhere) {
  ActivityMap map(kPixels);
  const std::array<Eigen::Vector2d, 4> view{Eigen::Vector2d(0, 0), {32, 0}, {32, 16}, {0, 16}};
  for (int i = 0; i < 5; ++i) map.look(view);
  map.look(std::array<Eigen::Vector2d, 1>{Eigen::Vector2d(NAN, 0.0)});
  EXPECT_EQ(map.exposure(128, 128), 5U);
  EXPECT_EQ(map.exposure(129, 128), 5U);
  EXPECT_EQ(map.exposure(130, 128), 0U);
  EXPECT_EQ(map.exposure(128, 129), 0U);
  EXPECT_EQ(map.exposure(-1, 0), 0U);
  ActivityMap turned(kPixels);
  turned.merge(map, 0.5 * M_PI, {0.0, 0.0});
  EXPECT_EQ(turned.exposure(127, 128), 5U);
  EXPECT_EQ(turned.exposure(127, 129), 5U);
  EXPECT_EQ(turned.exposure(128, 128), 0U);
}

TEST(ActivityPrior, TellsWhatIsUsualFromWhatIsNotAndFromWhatItNeverSaw) {
  ActivityMap map(kPixels);
  const std::array<Eigen::Vector2d, 4> view{
      Eigen::Vector2d(-320, -240), {320, -240}, {320, 240}, {-320, 240}};
  for (int i = 0; i < 600; ++i) map.look(view);
  for (int x = -300; x < 300; ++x) map.add({x, 8.0}, polar(5.0, 0.0));
  const ActivityPrior prior(map);
  EXPECT_GT(prior.log_ratio({0, 8}, {5, 0}), 3.0) << "usual here";
  EXPECT_LT(prior.log_ratio({0, 8}, {0, 5}), -0.3) << "elsewhere than it is usual to go";
  EXPECT_LT(prior.log_ratio({0, 150}, {5, 0}), -0.3) << "looked at for long, and nothing moved";
  EXPECT_EQ(prior.log_ratio({900, 900}, {5, 0}), 0.0) << "never seen";
}

TEST(ActivityPrior, TheLongerItLookedTheMoreNothingMeans) {
  double before = 0.0;
  for (const int frames : {100, 1000, 10000}) {
    ActivityMap map(kPixels);
    const std::array<Eigen::Vector2d, 4> view{
        Eigen::Vector2d(-320, -240), {320, -240}, {320, 240}, {-320, 240}};
    for (int i = 0; i < frames; ++i) {
      map.look(view);
      map.add({0.0, 0.0}, polar(5.0, 0.0));
    }
    const double now = ActivityPrior(map).log_ratio({150, 150}, {5, 0});
    EXPECT_LT(now, before);
    before = now;
  }
}

/// A map that never looked: nothing is known to be empty.
TEST(ActivityPrior, WithoutExposureOnlyMotionIsKnown) {
  ActivityMap map(kPixels);
  for (int i = 0; i < 30; ++i) map.add({5.0, 5.0}, polar(5.0, 0.0));
  const ActivityPrior prior(map);
  EXPECT_GT(prior.log_ratio({5, 5}, {5, 0}), 3.0);
  EXPECT_EQ(prior.log_ratio({200, 200}, {5, 0}), 0.0);
}

Track track_at(std::int32_t id, float x, int unseen = 0) {
  Track track;
  track.id = id, track.at_px = {x, 0.0F}, track.v_px = {2.0F, 0.0F}, track.unseen_frames = unseen;
  return track;
}

TEST(ActivityLearner, LearnsTheWholeWayOfWhatGotAwayAndNothingOfWhatSways) {
  ActivityMap map(kPixels);
  ActivityLearner learner;
  const Eigen::Matrix3d H = Eigen::Matrix3d::Identity();
  for (int frame = 0; frame < 40; ++frame) {
    const auto way = static_cast<float>(2 * frame);
    const float sway = 20.0F * std::sin(0.3F * static_cast<float>(frame));
    const std::array<Track, 3> tracks{track_at(1, way), track_at(2, 1000.0F + sway),
                                      track_at(3, 500.0F + way, 1)};
    learner.learn(tracks, {}, H, map);
    if (frame == 30) {
      EXPECT_EQ(map.total(), 0U) << "not yet proven";
    }
  }
  EXPECT_EQ(map.total(), 40U) << "from its first frame on";
  int column = 0, row = 0;
  map.cell_of({1.0, 0.0}, column, row);
  EXPECT_GE(map.find(column, row), 0);
  for (const auto& cell : map.active()) EXPECT_LT(map.middle_of(cell.column, cell.row).x(), 100.0);
}

}  // namespace
}  // namespace hindsight
