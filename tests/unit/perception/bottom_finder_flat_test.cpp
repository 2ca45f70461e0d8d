// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bottom_finder_scene.h"

namespace hindsight {
namespace {

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

}  // namespace
}  // namespace hindsight
