// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/bottom_finder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "bottom_finder_scene.h"

namespace hindsight {
namespace {

TEST(BottomFinder, TreeIsWhereItStands) {
  for (const int strip_px : {1, 2, 4, 8}) {
    for (const double y_m : {-1.5, 0.0, 1.5}) {
      Scene scene;
      scene.sky(kUnknown);
      scene.stand(6.0, y_m, 0.4, 3.0, kLethal);
      BottomFinderParams params;
      params.strip_px = strip_px;
      BottomFinder bottom = finder(scene, params);
      const Sum tree = sum_of(bottom.find(scene.labels), kLethal);
      EXPECT_NEAR(tree.x_m, 6.0, 0.1) << strip_px;
      EXPECT_NEAR(tree.y_m, y_m, 0.06) << strip_px << ": left in the picture is +y";
      EXPECT_NEAR(tree.weight, 0.4 * params.max_obstacle_m / (kCell_m * kCell_m), 2.0)
          << "its face, in cells; strips that are half covered count";
    }
  }
}

TEST(BottomFinder, MirroredPictureGivesMirroredVotes) {
  Scene left, right;
  left.stand(4.0, 1.2, 0.5, 1.0, kBad);
  for (int y = 0; y < 480; ++y)
    for (int x = 0; x < 720; ++x) right.at(719 - x, y) = left.at(x, y);
  BottomFinderParams params;
  params.strip_px = 1;
  BottomFinder a = finder(left, params), b = finder(right, params);
  const Sum l = sum_of(a.find(left.labels), kBad), r = sum_of(b.find(right.labels), kBad);
  EXPECT_GT(l.y_m, 1.0);
  EXPECT_NEAR(l.y_m, -r.y_m, 1e-4);
  EXPECT_NEAR(l.x_m, r.x_m, 1e-4);
  EXPECT_NEAR(l.weight, r.weight, 1e-3);
}

TEST(BottomFinder, NothingIsSeenBehindAnObstacle) {
  Scene scene;
  scene.stand(3.0, 0, 20.0, 5.0, kLethal);
  BottomFinder bottom = finder(scene);
  for (const GroundVote& v : bottom.find(scene.labels)) {
    // The board is square to the vehicle: where it stands, x is 3 m.
    EXPECT_LT(v.x_B_m, 3.15F);
  }
}

TEST(BottomFinder, ThesisCountsEveryPixelOnce) {
  // Seed 7: columns of good ground up to some row, obstacle above it up to another, unknown to the top.
  std::mt19937 random(7);
  Scene scene;
  const GroundPlane ground(scene.camera, thesis_finder().max_range_m);
  std::map<TerrainClass, int> expected;
  for (int x = 0; x < 720; ++x) {
    const int contact = 150 + int(random() % 330), top = int(random() % 150);
    for (int y = 0; y < 480; ++y) {
      const TerrainClass obstacle = random() % 3 == 0 ? kBad : kLethal;
      scene.at(x, y) = y > contact ? kGood : y > top ? obstacle : kUnknown;
      if (scene.at(x, y) != kUnknown) ++expected[scene.at(x, y)];
    }
  }
  BottomFinder bottom = finder(scene, thesis_finder());
  const auto votes = bottom.find(scene.labels);
  EXPECT_NEAR(sum_of(votes, kBad).weight, expected[kBad], 0.01 * expected[kBad]);
  EXPECT_NEAR(sum_of(votes, kLethal).weight, expected[kLethal], 0.01 * expected[kLethal]);
  EXPECT_NEAR(sum_of(votes, kGood).weight, expected[kGood], 0.02 * expected[kGood])
      << "a band that is partly obstacle counts as one or the other";
}

TEST(BottomFinder, OneFullLookAtACellWeighsOne) {
  Scene scene;
  BottomFinderParams params;
  params.sure_range_m = params.max_range_m;
  BottomFinder bottom = finder(scene, params);
  std::map<std::pair<int, int>, double> cells;
  for (const GroundVote& v : bottom.find(scene.labels))
    cells[{int(std::floor(v.x_B_m / kCell_m)), int(std::floor(v.y_B_m / kCell_m))}] += v.weight;
  double total = 0;
  int count = 0;
  for (int i = 10; i < 100; ++i) {           // 2 to 20 m ahead
    for (int j = -i / 2; j <= i / 2; ++j) {  // well within the field of view
      const double weight = cells[{i, j}];
      total += weight;
      ++count;
      EXPECT_GT(weight, 0.2) << i << ' ' << j;
      EXPECT_LT(weight, 2.5) << i << ' ' << j;
    }
  }
  EXPECT_NEAR(total / count, 1.0, 0.02);
}

TEST(BottomFinder, FarLooksWeighLess) {
  Scene scene;
  BottomFinderParams params;
  params.sure_range_m = 5;
  BottomFinder bottom = finder(scene, params);
  double far = 0;
  for (const GroundVote& v : bottom.find(scene.labels))
    if (v.x_B_m > 9.8F && v.x_B_m < 10.2F && std::abs(v.y_B_m) < 2.0F) far += v.weight;
  EXPECT_NEAR(far, 0.5 * 0.4 * 4.0 / (kCell_m * kCell_m), 3.0);
}

TEST(BottomFinder, SpecksAreNoObstacles) {
  Scene scene;
  std::mt19937 random(3);  // seed 3
  for (int n = 0; n < 500; ++n) scene.at(int(random() % 720), 100 + int(random() % 378)) = kLethal;
  BottomFinder bottom = finder(scene);
  const auto votes = bottom.find(scene.labels);
  EXPECT_EQ(sum_of(votes, kLethal).weight, 0);
  EXPECT_EQ(std::ranges::count(bottom.contact_row_px(), -1.0F), std::ssize(bottom.contact_row_px()));
}

TEST(BottomFinder, GroundSeenOverALowObstacleCountsAgain) {
  Scene scene;
  scene.sky(kUnknown);
  scene.stand(8.0, 0, 1.0, 2.0, kLethal);
  scene.stand(2.5, 0, 1.0, 0.4, kBad);
  BottomFinder bottom = finder(scene);
  const auto votes = bottom.find(scene.labels);
  EXPECT_NEAR(sum_of(votes, kBad).x_m, 2.5, 0.1);
  EXPECT_NEAR(sum_of(votes, kLethal).x_m, 8.0, 0.2);

  BottomFinder first_only = finder(scene, thesis_finder());
  EXPECT_LT(sum_of(first_only.find(scene.labels), kLethal).x_m, 4.0) << "the thesis adds it to the first";
}

TEST(BottomFinder, UnknownCountsAsConfigured) {
  Scene scene;
  scene.sky(kUnknown);
  scene.stand(5.0, 0, 1.0, 1.0, kUnknown);
  for (const auto& [unknown, obstacle] : {std::pair{"nothing", false}, {"good", false}, {"bad", true}}) {
    BottomFinderParams params;
    params.unknown = unknown;
    BottomFinder bottom = finder(scene, params);
    const auto votes = bottom.find(scene.labels);
    EXPECT_EQ(sum_of(votes, kBad).weight > 1, obstacle) << unknown;
    const bool ground_there = std::ranges::any_of(votes, [](const GroundVote& v) {
      return v.label == kGood && std::abs(v.x_B_m - 6.0F) < 0.5F && std::abs(v.y_B_m) < 0.3F;
    });
    EXPECT_EQ(ground_there, unknown == std::string("good")) << unknown;
  }
}

TEST(BottomFinder, SkyIsNoObstacle) {
  Scene scene;
  scene.sky(kBad);
  BottomFinder bottom = finder(scene);
  const auto votes = bottom.find(scene.labels);
  EXPECT_EQ(sum_of(votes, kBad).weight, 0);
  EXPECT_GT(sum_of(votes, kGood).weight, 1000);
}

TEST(BottomFinder, CameraThatSeesNoGroundCastsNoVotes) {
  Scene scene;
  scene.camera.set_orientation(0, -1.2, 0);
  BottomFinder bottom = finder(scene);
  EXPECT_TRUE(bottom.find(scene.labels).empty());
}

TEST(BottomFinder, ContactRowIsTheObstaclesFoot) {
  Scene scene;
  scene.stand(5.0, 0, 2.0, 1.0, kLethal);
  BottomFinder bottom = finder(scene);
  bottom.find(scene.labels);
  const double foot = scene.camera.project({5.0, 0, 0})->y_px;
  EXPECT_NEAR(bottom.contact_row_px()[static_cast<std::size_t>(360 / bottom.strip_px())], foot, 3);
  EXPECT_EQ(bottom.contact_row_px()[0], -1.0F);
}

TEST(BottomFinder, VotesNeverOutgrowTheirBuffer) {
  std::mt19937 random(11);  // seed 11
  Scene scene;
  BottomFinderParams params;
  params.min_run_px = 1;
  params.min_height_m = 0.0;
  params.ground_resumes_px = 1;
  BottomFinder bottom = finder(scene, params);
  const GroundVote* buffer = bottom.find(scene.labels).data();
  for (const int run : {1, 2, 3, 7}) {
    for (int y = 0; y < 480; ++y)
      for (int x = 0; x < 720; ++x)
        scene.at(x, y) = y % run == 0 ? TerrainClass(random() % 4) : scene.at(x, y - 1);
    EXPECT_EQ(bottom.find(scene.labels).data(), buffer);
  }
}

}  // namespace
}  // namespace hindsight
