// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/activity_registration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "config/crc32.h"
#include "perception/activity_codec.h"
#include "perception/saved_bytes.h"

namespace hindsight {
namespace {

constexpr ActivityMapParams kPixels{.cell = 16.0, .cells = 128, .max_speed = 12.0};

TEST(ActivityRegistration, FindsHowAMapWasTurnedAndMoved) {
  // Crossroads look the same after a quarter turn but for an arm that leads nowhere.
  ActivityMap a = crossroads_template(kPixels, 300.0, 30.0, 6.0);
  for (double x = 60.0; x < 240.0; x += 4.0) a.add({x, 150.0}, {2.0, 0.0});
  const double angle = 0.7;
  const Eigen::Vector2d t(50.0, -90.0);
  ActivityMap b(kPixels);
  b.merge(a, -angle,
          {-(std::cos(angle) * t.x() + std::sin(angle) * t.y()),
           std::sin(angle) * t.x() - std::cos(angle) * t.y()});
  const ActivityAlignment found = register_activity(a, b);
  EXPECT_LT(std::abs(std::remainder(found.angle_rad - angle, 2.0 * M_PI)) * 180.0 / M_PI, 3.0);
  EXPECT_LT((found.t - t).norm(), 2.0 * kPixels.cell);
  EXPECT_GT(found.likeness, 0.7);
}

/// What of `map` lies west of x.
ActivityMap west_of(const ActivityMap& map, double x) {
  ActivityMap west(map.params());
  for (std::size_t i = 0; i < map.active().size(); ++i) {
    const auto [column, row, total] = map.active()[i];
    if (map.middle_of(column, row).x() > x) continue;
    for (std::size_t bin = 0; bin < ActivityMap::kBins; ++bin) {
      if (map.counts(i)[bin] > 0) west.add_count(column, row, bin, map.counts(i)[bin]);
    }
  }
  return west;
}

/// The busiest arm, to the east, was out of the second flight's view: with any other arm laid over it, the
/// product of the two maps is larger than in truth.
TEST(ActivityRegistration, WhatOneMapDidNotLookAtCountsForNothing) {
  ActivityMap a = crossroads_template(kPixels, 300.0, 30.0, 6.0);
  for (double y = -280.0; y < -60.0; y += 2.0) a.add({0.0, y}, {0.0, 3.0});
  for (double x = 80.0; x < 300.0; x += 0.05) a.add({x, -30.0}, {-6.0, 0.0});
  ActivityMap b = west_of(a, 70.0);
  const auto look = [](ActivityMap& map, double east) {
    const std::array<Eigen::Vector2d, 4> view{Eigen::Vector2d(-400, -400), Eigen::Vector2d(east, -400),
                                              Eigen::Vector2d(east, 400), Eigen::Vector2d(-400, 400)};
    for (int frame = 0; frame < 30; ++frame) map.look(view);
  };
  look(a, 400.0), look(b, 70.0);
  const ActivityAlignment found = register_activity(a, b);
  EXPECT_LT(std::abs(std::remainder(found.angle_rad, 2.0 * M_PI)) * 180.0 / M_PI, 3.0);
  EXPECT_LT(found.t.norm(), 2.0 * kPixels.cell);
}

TEST(ActivityRegistration, TellsACrossroadsFromARoundabout) {
  const ActivityMap cross = crossroads_template(kPixels, 300.0, 30.0, 6.0),
                    ring = roundabout_template(kPixels, 300.0, 30.0, 6.0, 140.0);
  EXPECT_GT(register_activity(ring, ring).likeness, register_activity(ring, cross).likeness);
  EXPECT_GT(register_activity(cross, cross).likeness, register_activity(cross, ring).likeness);
}

TEST(ActivityRegistration, OfNothingIsNothing) {
  const ActivityMap empty(kPixels), cross = crossroads_template(kPixels, 300.0, 30.0, 6.0);
  EXPECT_EQ(register_activity(empty, cross).likeness, 0.0);
  EXPECT_EQ(register_activity(cross, empty).likeness, 0.0);
}

TEST(ActivityCodec, GivesBackWhatItWasGivenAndNothingElse) {
  ActivityMap map = roundabout_template(kPixels, 300.0, 30.0, 6.0, 140.0);
  map.look(std::array<Eigen::Vector2d, 3>{Eigen::Vector2d(-200, -200), {200, -100}, {0, 150}});
  const std::vector<std::uint8_t> bytes = encode_activity(map);
  const ActivityDecoded decoded = decode_activity(bytes);
  ASSERT_EQ(decoded.problem, "");
  EXPECT_EQ(encode_activity(*decoded.map), bytes);
  EXPECT_EQ(decoded.map->total(), map.total());
  EXPECT_GT(map.exposure(64, 60), 0U);
  EXPECT_TRUE(std::ranges::equal(decoded.map->exposures(), map.exposures()));
  EXPECT_FALSE(decode_activity({}).map) << "a refusal costs no map's memory";
  for (std::size_t cut = 0; cut < bytes.size(); cut += 97) {
    EXPECT_NE(decode_activity(std::span(bytes).first(cut)).problem, "") << cut;
  }
  for (std::size_t at = 0; at < bytes.size(); at += 131) {
    std::vector<std::uint8_t> damaged = bytes;
    damaged[at] ^= 0x10;
    EXPECT_NE(decode_activity(damaged).problem, "") << at;
  }
}

/// Written before maps knew how long they looked.
TEST(ActivityCodec, ReadsMapsOfTheFirstVersion) {
  ActivityMap map(kPixels);
  for (int i = 0; i < 3; ++i) map.add({5.0, 5.0}, {2.0, 0.0});
  std::vector<std::uint8_t> bytes = encode_activity(map);
  constexpr std::size_t kOneRun = 8, kChecksum = 4;
  bytes.resize(bytes.size() - kOneRun - kChecksum);
  bytes[4] = 1;
  put(bytes, crc32(bytes));
  const ActivityDecoded decoded = decode_activity(bytes);
  ASSERT_EQ(decoded.problem, "");
  EXPECT_EQ(decoded.map->total(), 3U);
  EXPECT_EQ(decoded.map->exposure(64, 64), 0U);
}

}  // namespace
}  // namespace hindsight
