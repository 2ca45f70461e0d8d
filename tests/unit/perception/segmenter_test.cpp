// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/segmenter.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <opencv2/imgcodecs.hpp>
#include <random>

namespace hindsight {
namespace {

MixtureParams params_of(const std::string& space, double gate, double floor,
                        const std::string& density = "labels") {
  MixtureParams params;
  params.class_density = density;
  params.color_space = space;
  params.gate = gate;
  params.eigenvalue_floor = floor;
  params.max_components = static_cast<int>(density == "labels" ? kMostComponents : kMostSharedComponents);
  return params;
}

/// Components of any shape and class around real colours.
TerrainMixture random_mixture(std::mt19937& random, const MixtureParams& params, int count) {
  std::uniform_int_distribution<int> byte(0, 255), votes(0, 3);
  std::normal_distribution<double> unit;
  std::uniform_real_distribution<double> log_sd(std::log(std::sqrt(params.eigenvalue_floor)), std::log(30.0));
  MixtureSnapshot mixture{parse_color_space(params.color_space), {}};
  for (int i = 0; i < count; ++i) {
    MixtureComponent c;
    const auto any = [&] { return static_cast<std::uint8_t>(byte(random)); };
    c.mean = color_of(mixture.color_space, any(), any(), any());
    Eigen::Matrix3d axes;
    for (double& v : axes.reshaped()) v = unit(random);
    axes = axes.colwise().normalized().eval() * std::exp(log_sd(random));
    c.covariance = axes * axes.transpose();
    for (double& v : c.votes) v = votes(random);
    c.weight_px = 100.0;
    mixture.components.push_back(c);
  }
  TerrainMixture result(params);
  EXPECT_EQ(result.restore(mixture), "");
  return result;
}

int mismatches(std::span<const std::uint8_t> bgr, std::span<const TerrainClass> labels,
               const TerrainMixture& mixture) {
  MixtureLikelihood likelihood(kMostComponents);  // what classify_reference asks, prepared once
  likelihood.set(mixture);
  int wrong = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::uint8_t* p = &bgr[3 * i];
    wrong += labels[i] != likelihood.classify(color_of(mixture.color_space(), p[0], p[1], p[2]));
  }
  return wrong;
}

std::vector<std::uint8_t> noise(std::mt19937& random, std::size_t pixels) {
  std::vector<std::uint8_t> bgr(3 * pixels);
  for (std::uint8_t& v : bgr) v = static_cast<std::uint8_t>(random());
  return bgr;
}

TEST(ClassifyReference, IsTheFormulasOfTheThesisWrittenOut) {
  std::mt19937 random(1);
  for (int round = 0; round < 40; ++round) {
    const TerrainMixture mixture = random_mixture(random, params_of("rgb", 3.0, 4.0), 12);
    const auto bgr = noise(random, 100);
    for (std::size_t i = 0; i < bgr.size(); i += 3) {
      const Eigen::Vector3d c(bgr[i + 2], bgr[i + 1], bgr[i]);
      double f[4] = {}, m[4] = {}, nearest = 1e300;
      for (const MixtureComponent& g : mixture.components()) {
        const double d2 = (c - g.mean).dot(g.covariance.inverse() * (c - g.mean));
        nearest = std::min(nearest, std::sqrt(d2));
        f[static_cast<int>(g.label)] +=
            std::exp(-0.5 * d2) / std::sqrt(std::pow(2 * std::numbers::pi, 3) * g.covariance.determinant());
        m[static_cast<int>(g.label)] += 1.0;
      }
      int best = 3;
      for (int l = 0; l < 4; ++l) f[l] /= std::max(m[l], 1.0);
      for (int l = 0; l < 4; ++l) best = f[l] > f[best] ? l : best;
      const auto expected = nearest > 3.0 ? TerrainClass::unknown : static_cast<TerrainClass>(best);
      EXPECT_EQ(classify_reference(mixture, bgr[i], bgr[i + 1], bgr[i + 2]), expected);
    }
  }
}

TEST(ClassifyReference, SharesGiveGroundAndObstaclesTheirOwnPartsInEachComponent) {
  std::mt19937 random(8);
  for (int round = 0; round < 40; ++round) {
    const TerrainMixture mixture = random_mixture(random, params_of("rgb", 3.0, 4.0, "shares"), 12);
    double all_good = 1.0, all_obstacle = 1.0;
    for (const MixtureComponent& g : mixture.components())
      all_good += g.votes[0], all_obstacle += g.votes[1] + g.votes[2];
    const auto bgr = noise(random, 100);
    for (std::size_t i = 0; i < bgr.size(); i += 3) {
      const Eigen::Vector3d c(bgr[i + 2], bgr[i + 1], bgr[i]);
      double f[3] = {}, nearest = 1e300;
      for (const MixtureComponent& g : mixture.components()) {
        if (g.label == TerrainClass::unknown) continue;
        const double d2 = (c - g.mean).dot(g.covariance.inverse() * (c - g.mean));
        const double density = std::exp(-0.5 * d2) / std::sqrt(g.covariance.determinant());
        nearest = std::min(nearest, std::sqrt(d2));
        f[0] += g.votes[0] / all_good * density;
        f[g.votes[2] >= g.votes[1] ? 2 : 1] += (g.votes[1] + g.votes[2]) / all_obstacle * density;
      }
      int best = 2;
      for (int l = 1; l >= 0; --l) best = f[l] > f[best] ? l : best;
      const auto expected = nearest > 3.0 ? TerrainClass::unknown : static_cast<TerrainClass>(best);
      EXPECT_EQ(classify_reference(mixture, bgr[i], bgr[i + 1], bgr[i + 2]), expected);
    }
  }
}

TEST(ClassifyReference, WithSharesManyLooksAtTheGroundDoNotOutvoteATouch) {
  using Patch = std::vector<std::array<std::uint8_t, 3>>;
  for (const auto& [density, expected] :
       {std::pair{"shares", TerrainClass::lethal}, std::pair{"labels", TerrainClass::good}}) {
    TerrainMixture mixture(params_of("rgb", 3.0, 4.0, density));
    Patch ground(90, {100, 100, 100}), bark(90, {60, 60, 60});
    ground.insert(ground.end(), 10, {60, 60, 60});  // a tenth of the ground is as dark as bark
    for (int meter = 0; meter < 40; ++meter) mixture.train(ground, TerrainClass::good);
    mixture.train(bark, TerrainClass::lethal);
    EXPECT_EQ(classify_reference(mixture, 60, 60, 60), expected) << density;
    EXPECT_EQ(classify_reference(mixture, 100, 100, 100), TerrainClass::good) << density;
  }
}

TEST(ClassifyReference, AnUntrainedComponentWinsAsUnknown) {
  MixtureSnapshot two{ColorSpace::rgb, std::vector<MixtureComponent>(2)};
  for (MixtureComponent& c : two.components) c.covariance *= 100.0;
  two.components[0].mean.setConstant(100.0);
  two.components[1].mean.setConstant(120.0);
  two.components[1].votes = {0.0, 0.0, 1.0};
  TerrainMixture mixture(params_of("rgb", 3.0, 4.0));
  ASSERT_EQ(mixture.restore(two), "");
  EXPECT_EQ(classify_reference(mixture, 105, 105, 105), TerrainClass::unknown);
  EXPECT_EQ(classify_reference(mixture, 115, 115, 115), TerrainClass::lethal);
  EXPECT_EQ(classify_reference(mixture, 110, 110, 110), TerrainClass::lethal);   // equal: the more severe
  EXPECT_EQ(classify_reference(mixture, 200, 200, 200), TerrainClass::unknown);  // beyond the gate
}

class SegmenterEquals
    : public testing::TestWithParam<std::tuple<const char*, const char*, double, double, int>> {};

TEST_P(SegmenterEquals, TheReferenceOnRandomMixturesAndColors) {
  const auto [density, space, gate, floor, count] = GetParam();
  std::mt19937 random(2);
  Segmenter segmenter(61, 37);  // no multiple of anything
  for (int round = 0; round < 4; ++round) {
    const MixtureParams params = params_of(space, gate, floor, density);
    const TerrainMixture mixture = random_mixture(random, params, std::min(count, params.max_components));
    for (int frame = 0; frame < 2; ++frame) {
      const auto bgr = noise(random, 61 * 37);
      EXPECT_EQ(mismatches(bgr, segmenter.segment(bgr, mixture), mixture), 0) << round;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Mixtures, SegmenterEquals,
                         testing::Combine(testing::Values("labels", "shares"), testing::Values("rgb", "lab"),
                                          testing::Values(0.9, 3.0, 6.0), testing::Values(0.1, 4.0),
                                          testing::Values(1, 32, 256)));

TEST(Segmenter, EqualsTheReferenceForAllColorsOfDenseCubes) {
  std::mt19937 random(3);
  Segmenter segmenter(512, 64);
  std::vector<std::uint8_t> bgr;
  for (int cube = 0; cube < 64; ++cube) {
    const unsigned corner = static_cast<unsigned>(random());
    for (unsigned i = 0; i < 512; ++i) {
      for (unsigned k = 0; k < 3; ++k)
        bgr.push_back(static_cast<std::uint8_t>((corner >> (8 * k) & 0xF8u) | (i >> (3 * k) & 7u)));
    }
  }
  for (const char* space : {"rgb", "lab"}) {
    const TerrainMixture mixture = random_mixture(random, params_of(space, 3.0, 4.0), 48);
    EXPECT_EQ(mismatches(bgr, segmenter.segment(bgr, mixture), mixture), 0) << space;
  }
}

TEST(Segmenter, ForgetsTheOldMixtureThroughMoreChangesThanItHasGenerations) {
  std::mt19937 random(4);
  Segmenter segmenter(64, 64);
  const auto bgr = noise(random, 64 * 64);
  for (int change = 0; change < 100; ++change) {
    const TerrainMixture mixture = random_mixture(random, params_of("rgb", 3.0, 4.0), 8);
    const auto part = change % 3 == 0 ? noise(random, 64 * 64) : bgr;
    ASSERT_EQ(mismatches(part, segmenter.segment(part, mixture), mixture), 0) << change;
  }
}

TEST(Segmenter, FollowsTrainingOfTheSameMixture) {
  std::mt19937 random(5);
  TerrainMixture mixture = random_mixture(random, params_of("lab", 3.0, 4.0), 16);
  Segmenter segmenter(64, 64);
  const auto bgr = noise(random, 64 * 64);
  for (int event = 0; event < 20; ++event) {
    std::vector<std::array<std::uint8_t, 3>> patch(50, {bgr[3 * static_cast<std::size_t>(event)], 100, 50});
    mixture.train(patch, static_cast<TerrainClass>(event % 3));
    ASSERT_EQ(mismatches(bgr, segmenter.segment(bgr, mixture), mixture), 0) << event;
  }
}

TEST(Segmenter, BeforeTheStartEverythingIsUnknown) {
  std::mt19937 random(6);
  Segmenter segmenter(16, 16);
  const auto bgr = noise(random, 256);
  EXPECT_EQ(count_labels(segmenter.segment(bgr, TerrainMixture(MixtureParams{}))),
            (std::array<int, 4>{0, 0, 0, 256}));
}

TEST(Segmenter, CountsAddUpToTheFrame) {
  std::mt19937 random(7);
  Segmenter segmenter(33, 21);
  const auto labels =
      segmenter.segment(noise(random, 33 * 21), random_mixture(random, params_of("rgb", 6, 4), 64));
  const auto counts = count_labels(labels);
  for (int l = 0; l < 4; ++l) {
    EXPECT_EQ(counts[static_cast<std::size_t>(l)], std::ranges::count(labels, static_cast<TerrainClass>(l)));
  }
  EXPECT_EQ(counts[0] + counts[1] + counts[2] + counts[3], 33 * 21);
}

TEST(Segmenter, EqualsTheReferenceOnRealFrames) {
  const char* data = std::getenv("HINDSIGHT_DATA");
  if (data == nullptr) GTEST_SKIP() << "no data";
  for (const char* space : {"rgb", "lab"}) {
    for (const double gate : {std::string(space) == "rgb" ? 0.9 : 3.0}) {
      for (const char* name : {"trail_ycor_run/1249/rgb.jpg", "road_kitti0019/000000.jpg"}) {
        const cv::Mat frame = cv::imread((std::filesystem::path(data) / name).string());
        ASSERT_FALSE(frame.empty()) << name;
        const std::span<const std::uint8_t> bgr(frame.data, frame.total() * 3);
        TerrainMixture mixture(params_of(space, gate, 4.0));
        mixture.start(bgr, frame.cols, frame.rows);
        std::vector<std::array<std::uint8_t, 3>> patch;
        for (int event = 0; event < 6; ++event) {
          patch.clear();
          for (int y = 0; y < 30; ++y) {
            const auto* row = frame.ptr<cv::Vec3b>(frame.rows - 40 - 30 * event + y);
            for (int x = 0; x < 40; ++x)
              patch.push_back({row[x + 90 * event][0], row[x + 90 * event][1], row[x + 90 * event][2]});
          }
          mixture.train(patch, static_cast<TerrainClass>(event % 3));
        }
        Segmenter segmenter(frame.cols, frame.rows);
        EXPECT_EQ(mismatches(bgr, segmenter.segment(bgr, mixture), mixture), 0) << name << space << gate;
      }
    }
  }
}

}  // namespace
}  // namespace hindsight
