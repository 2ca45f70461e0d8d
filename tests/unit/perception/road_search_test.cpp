// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace hindsight {
namespace {

constexpr int kWidth = 120;

/// Grey of value 200 is road, of 40 is not; the colours are taught just so.
struct Scene {
  std::vector<std::uint8_t> bgr;
  int rows;
  RoadColors colors;

  explicit Scene(int row_count) : bgr(static_cast<std::size_t>(3 * kWidth * row_count), 40), rows(row_count) {
    std::vector<std::uint8_t> sample(3 * 20 * 10, 200);
    colors.add(RoadColors::Side::road, {sample, 20, 10}, 0, 20, 0, 10, 1.0F);
    std::fill(sample.begin(), sample.end(), std::uint8_t{40});
    colors.add(RoadColors::Side::beside, {sample, 20, 10}, 0, 20, 0, 10, 1.0F);
    colors.refresh();
  }
  /// Row 0 of the profile is the lowest of the picture.
  void paint(int index, int left, int right, int grey = 200) {
    for (int x = std::max(left, 0); x < std::min(right, kWidth); ++x)
      for (int k = 0; k < 3; ++k)
        bgr[static_cast<std::size_t>(3 * ((rows - 1 - index) * kWidth + x) + k)] =
            static_cast<std::uint8_t>(grey);
  }
  RoadProfile profile() const {
    RoadProfile profile(rows, kWidth);
    for (int i = 0; i < rows; ++i) profile.fill(i, colors, {bgr, kWidth, rows}, rows - 1 - i, rows - i);
    return profile;
  }
};

TEST(RoadProfile, SumsAreThoseOfThePixelsAndUnknownOutside) {
  Scene scene(1);
  scene.paint(0, 30, 50);
  const RoadProfile profile = scene.profile();
  EXPECT_NEAR(profile.between(0, 30.0F, 50.0F), 20.0F, 0.01F);
  EXPECT_NEAR(profile.between(0, 0.0F, 30.0F), -30.0F, 0.01F);
  EXPECT_EQ(profile.between(0, -80.0F, 0.0F), 0.0F);
  EXPECT_EQ(profile.between(0, 120.0F, 300.0F), 0.0F);
}

TEST(RoadSearch, FindsABendingRoadThatIsWiderThanExpected) {
  Scene scene(12);
  std::vector<ExpectedRoad> expected;
  for (int i = 0; i < 12; ++i) {
    const float middle = 60.0F + 0.12F * static_cast<float>(i * i);
    const float half = 18.0F - static_cast<float>(i);
    scene.paint(i, static_cast<int>(middle - 1.25F * half), static_cast<int>(middle + 1.25F * half));
    expected.push_back({60.0F, half});
  }
  RoadSearch search(12, 1, 40);
  const auto found = search.find(scene.profile(), expected, 40, {});
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].middle_px, 60.0F + 0.12F * static_cast<float>(i * i), 2.0F) << i;
    EXPECT_NEAR(found[i].half_width_px / expected[i].half_width_px, 1.25F, 0.12F) << i;
    EXPECT_GT(found[i].contrast, 1.5F);
  }
}

/// The best of all paths of two rows, tried one by one.
float best_by_trying(const RoadProfile& profile, const std::vector<ExpectedRoad>& expected, int steps,
                     const RoadSearchCosts& costs) {
  const auto value = [&](int row, int i, int j) {
    const ExpectedRoad& here = expected[static_cast<std::size_t>(row)];
    const float offset = static_cast<float>(i), stray = offset / here.half_width_px;
    const float half = here.half_width_px * std::pow(RoadSearch::kWidthStep, static_cast<float>(j));
    return judge_road(profile, row, here.middle_px + offset, half, here.half_width_px).fit -
           costs.stray * stray * stray - costs.odd_width * static_cast<float>(j * j);
  };
  const int reach = std::clamp(static_cast<int>(0.35F * expected[1].half_width_px), 1, 6);
  float best = -1e9F;
  for (int i = -steps; i <= steps; ++i)
    for (int j = -4; j <= 4; ++j)
      for (int k = std::max(-steps, i - reach); k <= std::min(steps, i + reach); ++k)
        for (int l = std::max(-4, j - 1); l <= std::min(4, j + 1); ++l) {
          const float bend = static_cast<float>(i - k) / expected[1].half_width_px;
          best = std::max(best, value(0, k, l) + value(1, i, j) - costs.bend * bend * bend -
                                    (l == j ? 0.0F : costs.widen));
        }
  return best;
}

TEST(RoadSearch, IsAsGoodAsTryingEveryPath) {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
    std::mt19937 random(seed);
    Scene scene(2);
    for (int row = 0; row < 2; ++row)
      for (int x = 0; x < kWidth; x += 4) scene.paint(row, x, x + 4, random() % 2 == 0 ? 200 : 40);
    const std::vector<ExpectedRoad> expected{{60.0F, 14.0F}, {55.0F, 9.0F}};
    RoadSearch search(2, 1, 20);
    const RoadProfile profile = scene.profile();
    search.find(profile, expected, 15, {});
    EXPECT_NEAR(search.total(), best_by_trying(profile, expected, 15, {}), 1e-4F) << "seed " << seed;
  }
}

}  // namespace
}  // namespace hindsight
