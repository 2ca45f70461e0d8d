// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/ego_motion.h"

#include <gtest/gtest.h>

#include <random>

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

TEST(EgoMotion, OneHugeMoverIsNoGround) {
  // Three quarters of the view move alike: that is then the ground, as nothing in the flow says otherwise.
  // But two motions of which none has half of the features are told as none.
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
