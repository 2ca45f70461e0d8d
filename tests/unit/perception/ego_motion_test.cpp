// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/ego_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>
#include <vector>

namespace hindsight {
namespace {

constexpr double kNoise_px = 0.15;

Eigen::Matrix3d some_homography() {
  Eigen::Matrix3d H;
  H << 1.01, -0.02, 5.0, 0.018, 0.99, -3.0, 2e-5, -1e-5, 1.0;
  return H;
}

/// A grid of features that the ground carries by H, of which the first `movers` move by themselves.
std::vector<PointPair> scene(const Eigen::Matrix3d& H, std::size_t count, std::size_t movers, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> x(0.0F, 640.0F), y(0.0F, 360.0F);
  std::normal_distribution<float> noise(0.0F, static_cast<float>(kNoise_px));
  std::vector<PointPair> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    PointPair pair{{x(random), y(random)}, {}};
    if (i < movers) pair.now_px = {200.0F + 0.2F * pair.now_px.x_px, 100.0F + 0.2F * pair.now_px.y_px};
    pair.then_px = transformed(H, pair.now_px);
    pair.then_px.x_px += noise(random) + (i < movers ? 6.0F : 0.0F);
    pair.then_px.y_px += noise(random);
    pairs.push_back(pair);
  }
  return pairs;
}

double worst_error_px(const Eigen::Matrix3d& H, const Eigen::Matrix3d& truth) {
  double worst = 0.0;
  for (const Point2f p :
       {Point2f{0, 0}, Point2f{639, 0}, Point2f{0, 359}, Point2f{639, 359}, Point2f{320, 180}}) {
    const Point2f a = transformed(H, p), b = transformed(truth, p);
    worst = std::max(worst, static_cast<double>(std::hypot(a.x_px - b.x_px, a.y_px - b.y_px)));
  }
  return worst;
}

TEST(EgoMotion, FindsTheGroundAndWhatMovesOverIt) {
  for (const std::size_t movers : {std::size_t{0}, std::size_t{30}, std::size_t{80}}) {
    const auto pairs = scene(some_homography(), 400, movers, 20);
    std::vector<float> p(pairs.size());
    const EgoMotion motion = EgoMotionEstimator({}, pairs.size()).estimate(pairs, p);
    ASSERT_TRUE(motion.valid);
    EXPECT_LT(worst_error_px(motion.H_then_now, some_homography()), 0.2) << movers;
    EXPECT_NEAR(motion.residual_px, kNoise_px, 0.1) << movers;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < p.size(); ++i) wrong += (p[i] > 0.5F) != (i < movers);
    EXPECT_LT(wrong, pairs.size() / 100) << movers;
  }
}

TEST(EgoMotion, TheThesisAlphaOfExpTwoWouldCallEverythingMoving) {
  const auto pairs = scene(some_homography(), 400, 0, 21);
  std::vector<float> p(pairs.size());
  EgoMotionParams params;
  params.noise_px = 1.0;
  EXPECT_TRUE(EgoMotionEstimator(params, pairs.size()).estimate(pairs, p).valid);
  EXPECT_LT(*std::max_element(p.begin(), p.end()), 0.5F);
  params.log_alpha = 2.0;
  EXPECT_LT(EgoMotionEstimator(params, pairs.size()).estimate(pairs, p).static_share, 0.5);
}

std::size_t told_moving(std::span<const float> p) {
  return static_cast<std::size_t>(std::count_if(p.begin(), p.end(), [](float x) { return x > 0.5F; }));
}

/// The left `part` of the view moves 6 px on; these features come first.
std::vector<PointPair> scene_with_huge_mover(double part, unsigned seed) {
  auto pairs = scene(some_homography(), 400, 0, seed);
  std::sort(pairs.begin(), pairs.end(),
            [](const PointPair& a, const PointPair& b) { return a.now_px.x_px < b.now_px.x_px; });
  for (std::size_t i = 0; i < static_cast<std::size_t>(part * 400.0); ++i) pairs[i].then_px.x_px += 6.0F;
  return pairs;
}

TEST(EgoMotion, TheGroundIsWhatMoreThanHalfOfTheViewDoes) {
  Eigen::Matrix3d mover = Eigen::Matrix3d::Identity();
  mover(0, 2) = 6.0;
  for (const double part : {0.1, 0.2, 0.25, 0.3, 0.35, 0.4, 0.6, 0.65, 0.7, 0.75, 0.8, 0.9}) {
    const auto pairs = scene_with_huge_mover(part, 22);
    std::vector<float> p(pairs.size());
    const EgoMotion motion = EgoMotionEstimator({}, pairs.size()).estimate(pairs, p);
    ASSERT_TRUE(motion.valid) << part;
    const bool is_ground = part > 0.5;
    const Eigen::Matrix3d truth = is_ground ? mover * some_homography() : some_homography();
    EXPECT_LT(worst_error_px(motion.H_then_now, truth), 0.5) << part;
    const auto huge = static_cast<std::size_t>(part * 400.0);
    const std::size_t of_huge = told_moving(std::span(p).first(huge));
    const std::size_t of_rest = told_moving(std::span(p).subspan(huge));
    EXPECT_GE(is_ground ? of_rest : of_huge, (is_ground ? 400 - huge : huge) * 95 / 100) << part;
    EXPECT_LE(is_ground ? of_huge : of_rest, (is_ground ? huge : 400 - huge) * 5 / 100) << part;
  }
}

TEST(EgoMotion, ThreeMotionsOfWhichNoneHasHalfOfTheViewTellNothing) {
  auto pairs = scene(some_homography(), 300, 0, 22);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs[i].then_px.x_px += i % 3 == 0 ? 9.0F : (i % 3 == 1 ? -7.0F : 0.0F);
    pairs[i].then_px.y_px += static_cast<float>(i % 3) * 5.0F;
  }
  std::vector<float> p(pairs.size());
  EgoMotionParams params;
  params.noise_px = 0.3;
  EXPECT_FALSE(EgoMotionEstimator(params, pairs.size()).estimate(pairs, p).valid);
  EXPECT_EQ(*std::max_element(p.begin(), p.end()), 0.0F);
}

TEST(EgoMotion, TooFewFeaturesTellNothing) {
  const auto pairs = scene(some_homography(), 11, 0, 23);
  std::vector<float> p(pairs.size(), 1.0F);
  EXPECT_FALSE(EgoMotionEstimator({}, 11).estimate(pairs, p).valid);
  EXPECT_FALSE(EgoMotionEstimator({}, 11).estimate({}, {}).valid);
  EXPECT_EQ(p[0], 0.0F);
}

TEST(EgoMotion, IsTheSameEveryTime) {
  const auto pairs = scene(some_homography(), 300, 40, 24);
  std::vector<float> p(pairs.size()), q(pairs.size());
  EgoMotionEstimator a({}, pairs.size()), b({}, pairs.size());
  b.estimate(scene(some_homography(), 200, 10, 25), q);
  EXPECT_EQ(a.estimate(pairs, p).H_then_now, b.estimate(pairs, q).H_then_now);
  EXPECT_EQ(p, q);
}

}  // namespace
}  // namespace hindsight
