// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/texture_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace hindsight {
namespace {

using Codes = std::vector<std::uint8_t>;
constexpr double kFar = 100.0;

TEST(TextureModel, SaysNothingBeforeBothGroundAndObstaclesAreKnown) {
  TextureModel model;
  EXPECT_EQ(model.log_ratios(2.0), TextureLogRatios{});
  model.train(Codes{1, 2, 3}, TerrainClass::good);
  EXPECT_EQ(model.log_ratios(2.0), TextureLogRatios{});
  model.train(Codes{4}, TerrainClass::unknown);
  model.train(Codes{}, TerrainClass::lethal);
  EXPECT_EQ(model.log_ratios(2.0), TextureLogRatios{});
  model.train(Codes{4}, TerrainClass::bad);
  EXPECT_GT(model.log_ratios(2.0)[4], 0.0f);
  EXPECT_LT(model.log_ratios(2.0)[2], 0.0f);
  EXPECT_EQ(model.log_ratios(2.0)[9], 0.0f) << "never seen, and as often";
}

TEST(TextureModel, RatiosAreThoseOfTheShares) {
  TextureModel model;
  model.train(Codes{0, 0, 0, 1}, TerrainClass::good);
  model.train(Codes{0, 1, 1, 1}, TerrainClass::lethal);
  model.train(Codes{1}, TerrainClass::bad);
  const double prior = 0.1 / kTextureCodes;
  EXPECT_NEAR(model.log_ratios(kFar)[0], std::log((0.25 / 3 + prior) / (0.75 / 2 + prior)), 1e-6);
  EXPECT_NEAR(model.log_ratios(kFar)[1], std::log((1.75 / 3 + prior) / (0.25 / 2 + prior)), 1e-6);
  EXPECT_EQ(model.log_ratios(0.5)[0], -0.5f) << "limited";
}

TEST(TextureModel, GroundSeenOftenDoesNotOutvoteATouch) {
  TextureModel model;
  model.train(Codes{5, 5, 5, 6}, TerrainClass::lethal);
  model.train(Codes{5, 6, 6, 6}, TerrainClass::good);
  const TextureLogRatios before = model.log_ratios(kFar);
  for (int meter = 0; meter < 100; ++meter) model.train(Codes{5, 6, 6, 6}, TerrainClass::good);
  // Not believing the first look is worth a factor of two, and no more.
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR(model.log_ratios(kFar)[i], before[i], std::log(2.0));
}

TEST(TextureModel, ForgetsTheOldestInTheLongRun) {
  TextureModel model;
  for (int meter = 0; meter < 1000; ++meter) model.train(Codes{5}, TerrainClass::good);
  const auto& good = model.votes()[0];
  const double before = std::accumulate(good.begin(), good.end(), 0.0);
  for (int meter = 0; meter < 500; ++meter) model.train(Codes{6}, TerrainClass::good);
  EXPECT_NEAR(std::accumulate(good.begin(), good.end(), 0.0), before, 1e-9);
  EXPECT_LT(good[5], 0.1 * good[6]);
}

}  // namespace
}  // namespace hindsight
