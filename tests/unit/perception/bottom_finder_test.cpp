// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/bottom_finder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

namespace hindsight {
namespace {

constexpr double kCell_m = 0.2;
constexpr auto kGood = TerrainClass::good, kBad = TerrainClass::bad, kLethal = TerrainClass::lethal,
               kUnknown = TerrainClass::unknown;

CameraModel test_camera() {
  CameraModel camera;
  camera.width_px = 720;
  camera.height_px = 480;
  camera.fx_px = camera.fy_px = 420;
  camera.cx_px = 359.5;
  camera.cy_px = 239.5;
  camera.p_BC_m = {-0.1, 0, 1.0};
  camera.set_orientation(0, 0.35, 0);
  camera.set_field_of_view();
  return camera;
}

struct Scene {
  CameraModel camera = test_camera();
  std::vector<TerrainClass> labels = std::vector<TerrainClass>(720 * 480, kGood);

  TerrainClass& at(int x, int y) { return labels[static_cast<std::size_t>(y * camera.width_px + x)]; }
  void fill(int x0, int x1, int y0, int y1, TerrainClass label) {
    x0 = std::max(x0, 0), x1 = std::min(x1, camera.width_px);
    for (int y = y0; y < y1; ++y) std::fill(&at(x0, y), &at(x1 - 1, y) + 1, label);
  }
  void sky(TerrainClass label) { fill(0, 720, 0, 87, label); }
  /// A board that stands on the ground at (x, y), square to the vehicle.
  void stand(double x_m, double y_m, double width_m, double height_m, TerrainClass label) {
    const auto foot = camera.project({x_m, y_m, 0}), top = camera.project({x_m, y_m, height_m});
    const double left = camera.project({x_m, y_m + width_m / 2, 0})->x_px,
                 right = camera.project({x_m, y_m - width_m / 2, 0})->x_px;
    fill(int(std::lround(left)), int(std::lround(right)), std::max(0, int(std::lround(top->y_px))),
         int(std::lround(foot->y_px)), label);
  }
};

struct Sum {
  double weight = 0, x_m = 0, y_m = 0;
};

Sum sum_of(std::span<const GroundVote> votes, TerrainClass label) {
  Sum sum;
  for (const GroundVote& v : votes) {
    if (v.label != label) continue;
    sum.weight += v.weight;
    sum.x_m += v.weight * v.x_B_m;
    sum.y_m += v.weight * v.y_B_m;
  }
  sum.x_m /= sum.weight;
  sum.y_m /= sum.weight;
  return sum;
}

BottomFinder finder(const Scene& scene, const BottomFinderParams& params = {}) {
  return {params, scene.camera, GroundPlane(scene.camera, params.max_range_m), kCell_m};
}

BottomFinderParams thesis() {
  BottomFinderParams params;
  params.strip_px = 1;
  params.min_run_px = 1;
  params.min_height_m = 0.0;
  params.ground_resumes_px = 0;
  params.weighting = "pixels";
  return params;
}

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
  const GroundPlane ground(scene.camera, thesis().max_range_m);
  std::map<TerrainClass, int> expected;
  for (int x = 0; x < 720; ++x) {
    const int contact = 150 + int(random() % 330), top = int(random() % 150);
    for (int y = 0; y < 480; ++y) {
      const TerrainClass obstacle = random() % 3 == 0 ? kBad : kLethal;
      scene.at(x, y) = y > contact ? kGood : y > top ? obstacle : kUnknown;
      if (scene.at(x, y) != kUnknown) ++expected[scene.at(x, y)];
    }
  }
  BottomFinder bottom = finder(scene, thesis());
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

TEST(BottomFinder, WhatLiesFlatIsNoObstacle) {
  for (const double range_m : {3.0, 6.0, 12.0}) {
    Scene scene;
    scene.sky(kUnknown);
    const auto row = [&](double x_m) { return int(std::lround(scene.camera.project({x_m, 0, 0})->y_px)); };
    scene.fill(300, 420, row(range_m + 0.5), row(range_m), kLethal);  // a shadow, half a metre long
    BottomFinder default_finder = finder(scene);
    EXPECT_EQ(sum_of(default_finder.find(scene.labels), kLethal).weight, 0) << range_m;
    BottomFinderParams params;
    params.min_run_px = 1;
    params.min_height_m = 0.0;
    BottomFinder anything = finder(scene, params);
    EXPECT_GT(sum_of(anything.find(scene.labels), kLethal).weight, 0) << range_m;
    scene.stand(range_m, 0, 0.4, 0.5, kLethal);
    BottomFinder bottom = finder(scene);
    EXPECT_NEAR(sum_of(bottom.find(scene.labels), kLethal).x_m, range_m, 0.03 * range_m);
  }
}

TEST(BottomFinder, BadGroundMayLieFlat) {
  Scene scene;
  scene.sky(kUnknown);
  const auto row = [&](double x_m) { return int(std::lround(scene.camera.project({x_m, 0, 0})->y_px)); };
  scene.fill(300, 420, row(3.5), row(3.0), kBad);
  BottomFinder bottom = finder(scene);
  EXPECT_NEAR(sum_of(bottom.find(scene.labels), kBad).x_m, 3.0, 0.1);
}

TEST(BottomFinder, SpeckledGroundBeforeATreeDoesNotBringItNearer) {
  std::mt19937 random(5);  // seed 5
  Scene scene;
  scene.sky(kUnknown);
  for (TerrainClass& label : scene.labels)
    if (label == kGood && random() % 4 == 0) label = kLethal;
  scene.stand(9.0, 0, 0.5, 3.0, kLethal);
  BottomFinder bottom = finder(scene);
  const Sum tree = sum_of(bottom.find(scene.labels), kLethal);
  EXPECT_NEAR(tree.x_m, 9.0, 0.4);
  EXPECT_NEAR(tree.y_m, 0.0, 0.1);
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

  BottomFinder first_only = finder(scene, thesis());
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
