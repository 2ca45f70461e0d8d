// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/terrain_mixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

#include "perception/segmenter.h"

namespace hindsight {
namespace {

using Pixels = std::vector<std::array<std::uint8_t, 3>>;

std::uint8_t byte_of(double v) { return static_cast<std::uint8_t>(std::clamp(std::lround(v), 0l, 255l)); }

/// Pixels scattered around one colour.
Pixels cloud(std::mt19937& random, double b, double g, double r, double sd, int count) {
  std::normal_distribution<double> noise(0.0, sd);
  Pixels pixels;
  for (int i = 0; i < count; ++i) {
    pixels.push_back({byte_of(b + noise(random)), byte_of(g + noise(random)), byte_of(r + noise(random))});
  }
  return pixels;
}

constexpr int kWidth = 96, kHeight = 64;

/// Sky above, grass below, a brown trail in the middle of it: what the robot sees first.
std::vector<std::uint8_t> meadow(unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::uint8_t> bgr;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool sky = y < kHeight / 3, trail = !sky && std::abs(x - kWidth / 2) < kWidth / 6;
      const Pixels p = sky     ? cloud(random, 230, 190, 150, 5, 1)
                       : trail ? cloud(random, 90, 120, 150, 8, 1)
                               : cloud(random, 50, 120, 70, 12, 1);
      bgr.insert(bgr.end(), p[0].begin(), p[0].end());
    }
  }
  return bgr;
}

MixtureParams rgb_params() {
  MixtureParams params;
  params.color_space = "rgb";
  params.start_components = 8;
  return params;
}

TerrainMixture started(const MixtureParams& params) {
  TerrainMixture mixture(params);
  mixture.start(meadow(1), kWidth, kHeight);
  return mixture;
}

double least_eigenvalue(const MixtureComponent& c) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(c.covariance).eigenvalues()[0];
}

TEST(VoteLabel, MostVotesWinAndTiesGoToTheMoreSevere) {
  EXPECT_EQ(vote_label({3, 2, 1}, 0), TerrainClass::good);
  EXPECT_EQ(vote_label({1, 2, 1}, 0), TerrainClass::bad);
  EXPECT_EQ(vote_label({2, 2, 2}, 0), TerrainClass::lethal);
  EXPECT_EQ(vote_label({2, 2, 0}, 0), TerrainClass::bad);
}

TEST(VoteLabel, NoOrTooFewVotesMeanUnknown) {
  EXPECT_EQ(vote_label({0, 0, 0}, 0), TerrainClass::unknown);
  EXPECT_EQ(vote_label({0, 0, 0.04}, 0.05), TerrainClass::unknown);
  EXPECT_EQ(vote_label({0, 0, 0.05}, 0.05), TerrainClass::lethal);
}

TEST(TerrainMixture, StartsWithClustersThatNobodyHasVotedOn) {
  for (const char* space : {"rgb", "lab"}) {
    MixtureParams params = rgb_params();
    params.color_space = space;
    const TerrainMixture mixture = started(params);
    ASSERT_EQ(mixture.components().size(), 8u);
    double weight_px = 0.0;
    for (const MixtureComponent& c : mixture.components()) {
      EXPECT_EQ(c.label, TerrainClass::unknown);
      EXPECT_GE(least_eigenvalue(c), params.eigenvalue_floor * (1 - 1e-9));
      weight_px += c.weight_px;
    }
    EXPECT_NEAR(weight_px, kWidth * kHeight, 1e-6);
  }
}

TEST(TerrainMixture, StartIsTheSameForTheSameSeedAndFrame) {
  EXPECT_EQ(started(rgb_params()).components(), started(rgb_params()).components());
}

TEST(TerrainMixture, AFrameOfOneColorMakesOneComponent) {
  TerrainMixture mixture(rgb_params());
  mixture.start(std::vector<std::uint8_t>(3 * 64, 77), 8, 8);
  ASSERT_EQ(mixture.components().size(), 1u);
  EXPECT_TRUE(mixture.components()[0].mean.isApproxToConstant(77.0));
  EXPECT_NEAR(least_eigenvalue(mixture.components()[0]), rgb_params().eigenvalue_floor, 1e-9);
}

TEST(TerrainMixture, PixelsInsideTheGateVoteAndPullTheNearestComponent) {
  TerrainMixture mixture = started(rgb_params());
  const MixtureComponent before = mixture.components()[0];
  const Eigen::Vector3d near = before.mean + Eigen::Vector3d(1.0, 0.0, 0.0);
  const Pixels pixels(100, {byte_of(near[2]), byte_of(near[1]), byte_of(near[0])});
  const auto report = mixture.train(pixels, TerrainClass::bad);
  EXPECT_EQ(report.pixels, 100);
  EXPECT_EQ(report.new_components, 0);
  ASSERT_EQ(report.updated_component, 0);
  const MixtureComponent& after = mixture.components()[0];
  EXPECT_EQ(after.label, TerrainClass::bad);
  EXPECT_DOUBLE_EQ(after.votes[1], 1.0);
  EXPECT_DOUBLE_EQ(after.weight_px, before.weight_px + 100);
  const Eigen::Vector3d seen(pixels[0][2], pixels[0][1], pixels[0][0]);
  const Eigen::Vector3d expected = before.mean + 100.0 / after.weight_px * (seen - before.mean);
  EXPECT_TRUE(after.mean.isApprox(expected, 1e-12));
}

TEST(TerrainMixture, VoteUnitPixelCountsEachPixel) {
  MixtureParams params = rgb_params();
  params.vote_unit = "pixel";
  params.memory_votes = 1e9;
  TerrainMixture mixture = started(params);
  const Eigen::Vector3d m = mixture.components()[2].mean;
  mixture.train(Pixels(37, {byte_of(m[2]), byte_of(m[1]), byte_of(m[0])}), TerrainClass::good);
  EXPECT_DOUBLE_EQ(mixture.components()[2].votes[0], 37.0);
}

// Thesis figure 5.4: the robot touches an orange fence, whose colour the first frame did not have.
TEST(TerrainMixture, AnOrangeFenceBecomesANewLethalComponent) {
  std::mt19937 random(5);
  for (const char* space : {"rgb", "lab"}) {
    MixtureParams params = rgb_params();
    params.color_space = space;
    TerrainMixture mixture = started(params);
    mixture.train(cloud(random, 90, 120, 150, 8, 300), TerrainClass::good);
    mixture.train(cloud(random, 50, 120, 70, 12, 300), TerrainClass::good);
    ASSERT_EQ(classify_reference(mixture, 30, 110, 240), TerrainClass::unknown);
    const std::size_t before = mixture.components().size();
    const auto report = mixture.train(cloud(random, 30, 110, 240, 4, 400), TerrainClass::lethal);
    EXPECT_GE(report.new_components, 1);
    EXPECT_GE(report.updated_component, static_cast<int>(before));
    EXPECT_EQ(classify_reference(mixture, 30, 110, 240), TerrainClass::lethal) << space;
    EXPECT_EQ(classify_reference(mixture, 90, 120, 150), TerrainClass::good) << space;
    EXPECT_EQ(classify_reference(mixture, 50, 120, 70), TerrainClass::good) << space;
    EXPECT_EQ(classify_reference(mixture, 230, 190, 150), TerrainClass::unknown)
        << space;  // nobody voted on sky
  }
}

TEST(TerrainMixture, GroundInALethalPatchRecoversThroughDrivenOverGround) {
  std::mt19937 random(6);
  TerrainMixture mixture = started(rgb_params());
  Pixels patch = cloud(random, 30, 110, 240, 4, 200);
  const Pixels ground = cloud(random, 90, 120, 150, 6, 200);
  patch.insert(patch.end(), ground.begin(), ground.end());
  mixture.train(patch, TerrainClass::lethal);
  EXPECT_EQ(classify_reference(mixture, 90, 120, 150), TerrainClass::lethal);
  mixture.train(cloud(random, 90, 120, 150, 6, 60), TerrainClass::good);
  EXPECT_EQ(classify_reference(mixture, 90, 120, 150), TerrainClass::good);
  EXPECT_EQ(classify_reference(mixture, 30, 110, 240), TerrainClass::lethal);
}

TEST(TerrainMixture, OldVotesFadeSoThatALongDriveCanBeOverruled) {
  std::mt19937 random(7);
  MixtureParams params = rgb_params();
  params.class_density = "labels";
  TerrainMixture mixture = started(params);
  const Pixels ground = cloud(random, 90, 120, 150, 1, 50);
  for (int i = 0; i < 500; ++i) mixture.train(ground, TerrainClass::good);
  ASSERT_EQ(classify_reference(mixture, 90, 120, 150), TerrainClass::good);
  int needed = 0;
  for (; classify_reference(mixture, 90, 120, 150) != TerrainClass::lethal && needed < 100; ++needed) {
    mixture.train(ground, TerrainClass::lethal);
  }
  EXPECT_LE(needed, static_cast<int>(rgb_params().memory_votes));
  EXPECT_GT(needed, 3);
}

TEST(TerrainMixture, StrayColorsMakeNoComponent) {
  std::mt19937 random(8);
  TerrainMixture mixture = started(rgb_params());
  Pixels patch = cloud(random, 90, 120, 150, 4, 300);
  patch.push_back({255, 0, 255});
  const auto report = mixture.train(patch, TerrainClass::good);
  EXPECT_EQ(report.new_components, 0);
  EXPECT_GE(report.left_out, 1);
}

TEST(TerrainMixture, RepeatedTrainingDoesNotShrinkAComponent) {
  std::mt19937 random(9);
  const auto spread_after = [&](const std::string& update) {
    MixtureParams params = rgb_params();
    params.covariance_update = update;
    params.start_components = 1;
    params.gate = 2.0;
    params.memory_px = 2000;
    params.new_component_share = 1.0;
    TerrainMixture mixture(params);
    std::vector<std::uint8_t> bgr;
    for (const auto& p : cloud(random, 120, 120, 120, 15, 4096)) bgr.insert(bgr.end(), p.begin(), p.end());
    mixture.start(bgr, 64, 64);
    for (int i = 0; i < 60; ++i) mixture.train(cloud(random, 120, 120, 120, 15, 1000), TerrainClass::good);
    return std::sqrt(mixture.components()[0].covariance.trace() / 3.0);
  };
  EXPECT_NEAR(spread_after("unbiased"), 15.0, 2.0);
  EXPECT_LT(spread_after("raw"), 8.0);
}

TEST(TerrainMixture, NeverExceedsTheCapAndKeepsWhatHasVotes) {
  std::mt19937 random(10);
  MixtureParams params = rgb_params();
  params.max_components = 12;
  params.gate = 0.9;
  TerrainMixture mixture = started(params);
  for (int i = 0; i < 10; ++i) mixture.train(Pixels(50, {30, 110, 240}), TerrainClass::lethal);
  std::uniform_int_distribution<int> any(0, 255);
  int replaced = 0;
  for (int event = 0; event < 200; ++event) {
    const double b = any(random), g = any(random), r = any(random);
    replaced += mixture.train(cloud(random, b, g, r, 10, 100), TerrainClass::good).replaced_components;
    ASSERT_LE(mixture.components().size(), 12u);
    for (const MixtureComponent& c : mixture.components()) {
      ASSERT_TRUE(c.mean.allFinite() && c.covariance.allFinite());
      ASSERT_GE(least_eigenvalue(c), params.eigenvalue_floor * (1 - 1e-9));
    }
  }
  EXPECT_GT(replaced, 0);
  EXPECT_EQ(classify_reference(mixture, 30, 110, 240), TerrainClass::lethal);
}

TEST(TerrainMixture, VersionChangesExactlyWithTheComponents) {
  TerrainMixture mixture(rgb_params());
  const auto fresh = mixture.version();
  EXPECT_FALSE(mixture.started());
  mixture.start({}, 0, 0);
  mixture.train({}, TerrainClass::good);
  mixture.train(Pixels(10, {1, 2, 3}), TerrainClass::unknown);
  EXPECT_EQ(mixture.version(), fresh);
  mixture.start(meadow(1), kWidth, kHeight);
  const auto begun = mixture.version();
  EXPECT_NE(begun, fresh);
  EXPECT_TRUE(mixture.started());
  Pixels rainbow;  // all stray
  for (int i = 0; i < 200; ++i)
    rainbow.push_back({static_cast<std::uint8_t>(i), 255, static_cast<std::uint8_t>(255 - i)});
  const auto components = mixture.components();
  const auto report = mixture.train(rainbow, TerrainClass::good);
  EXPECT_EQ(mixture.version() == begun, mixture.components() == components) << report.left_out;
  mixture.train(Pixels(10, {90, 120, 150}), TerrainClass::good);
  EXPECT_NE(mixture.version(), begun);
}

TEST(TerrainMixture, GoesOnFromASnapshotAsIfNothingHadHappened) {
  std::mt19937 random(11);
  TerrainMixture mixture = started(rgb_params()), other(rgb_params());
  mixture.train(cloud(random, 30, 110, 240, 4, 200), TerrainClass::lethal);
  EXPECT_EQ(other.restore(mixture.snapshot()), "");
  const Pixels next = cloud(random, 90, 120, 150, 6, 60);
  mixture.train(next, TerrainClass::good);
  other.train(next, TerrainClass::good);
  EXPECT_EQ(mixture.components(), other.components());
}

TEST(TerrainMixture, RefusesASnapshotThatDoesNotFit) {
  const TerrainMixture mixture = started(rgb_params());
  MixtureParams lab = rgb_params(), small = rgb_params();
  lab.color_space = "lab";
  small.max_components = 4;
  TerrainMixture in_lab(lab), with_four(small);
  EXPECT_THAT(in_lab.restore(mixture.snapshot()), testing::HasSubstr("colour space"));
  EXPECT_THAT(with_four.restore(mixture.snapshot()), testing::HasSubstr("8 components"));
  EXPECT_FALSE(in_lab.started());
}

}  // namespace
}  // namespace hindsight
