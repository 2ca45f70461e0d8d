// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_rise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace hindsight {
namespace {

constexpr int kWidth = 240, kHeight = 160;
constexpr float kHorizon = 50.0F, kSlope = 0.8F, kMiddle = 120.0F;

/// Grey of about 180 is road, of about 60 is not; the hinge is 25 rows below the horizon, whence a flat road
/// is expected straight on.
class Scene {
 public:
  using Edges = std::function<std::pair<float, float>(float row)>;

  /// `edges` tells the road's middle and half width in a row; 0: no road.
  explicit Scene(const Edges& edges) : bgr_(3 * kWidth * kHeight) {
    std::mt19937 random(7);
    std::normal_distribution<float> noise(0.0F, 15.0F);
    for (int y = 0; y < kHeight; ++y) {
      const auto [middle, half] = edges(static_cast<float>(y));
      for (int x = 0; x < kWidth; ++x) {
        const bool road = std::abs(static_cast<float>(x) - middle) < half;
        const float grey = std::clamp((road ? 180.0F : 60.0F) + noise(random), 0.0F, 255.0F);
        std::fill_n(&bgr_[static_cast<std::size_t>(3 * (y * kWidth + x))], 3,
                    static_cast<std::uint8_t>(grey));
      }
    }
    teach(RoadColors::Side::road, 180);
    teach(RoadColors::Side::beside, 60);
    colors_.refresh();
    for (float row = kHorizon + 25.0F; row > kHorizon - 5.0F; row -= 5.0F) {
      rows_.push_back({row, static_cast<int>(row), static_cast<int>(row) + 1});
      roads_.push_back({kMiddle, std::max(2.5F, kSlope * (row - kHorizon)), 0.0F, 0.0F});
    }
  }

  bool find(RoadRise& rise) const {
    return rise.find({kHorizon, rows_, roads_}, colors_, {bgr_, kWidth, kHeight});
  }

 private:
  void teach(RoadColors::Side side, int grey) {
    std::vector<std::uint8_t> sample(3 * 40);
    for (int i = 0; i < 40; ++i)
      std::fill_n(&sample[static_cast<std::size_t>(3 * i)], 3, static_cast<std::uint8_t>(grey - 20 + i));
    colors_.add(side, {sample, 40, 1}, 0, 40, 0, 1, 100.0F);
  }

  std::vector<std::uint8_t> bgr_;
  RoadColors colors_;
  std::vector<SearchRow> rows_;
  std::vector<FoundRoad> roads_;
};

std::pair<float, float> flat_road(float row) {
  return {kMiddle, row > kHorizon ? kSlope * (row - kHorizon) : 0.0F};
}

/// Flat up to 10 rows below the horizon; from there on a slope, on which the road bends aside up to 20 rows
/// above it.
std::pair<float, float> risen_road(float row) {
  if (row > kHorizon + 10.0F) return flat_road(row);
  const float up = kHorizon + 10.0F - row;
  return {kMiddle - 1.5F * up, up < 30.0F ? 8.0F - 0.1F * up : 0.0F};
}

TEST(RoadRise, LeavesARoadOnFlatGroundAlone) {
  RoadRise rise(kWidth);
  EXPECT_FALSE(Scene(flat_road).find(rise));
  EXPECT_TRUE(rise.rows().empty());
}

TEST(RoadRise, LeavesARoadThatEndsAtACrestAlone) {
  RoadRise rise(kWidth);
  const Scene scene([](float row) {
    return std::pair{kMiddle, row > kHorizon + 12.0F ? kSlope * (row - kHorizon) : 0.0F};
  });
  EXPECT_FALSE(scene.find(rise));
}

TEST(RoadRise, FollowsARoadUpASlopeAboveTheHorizonOfFlatGround) {
  RoadRise rise(kWidth);
  ASSERT_TRUE(Scene(risen_road).find(rise));
  const auto rows = rise.rows();
  const auto roads = rise.roads();
  ASSERT_EQ(rows.size(), roads.size());
  EXPECT_NEAR(rows.back().row, kHorizon - 20.0F, 3.0F);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (k > 0) {
      EXPECT_LT(rows[k].row, rows[k - 1].row);
    }
    if (rows[k].row < kHorizon - 17.0F) continue;
    const auto [middle, half] = risen_road(rows[k].row);
    EXPECT_NEAR(roads[k].middle_px, middle, 3.5F) << rows[k].row;
    EXPECT_NEAR(roads[k].half_width_px, half, 0.35F * half) << rows[k].row;
  }
}

TEST(RoadRise, ForgetsWhatItToldOfThePictureBefore) {
  RoadRise rise(kWidth);
  ASSERT_TRUE(Scene(risen_road).find(rise));
  EXPECT_FALSE(Scene(flat_road).find(rise));
  EXPECT_TRUE(rise.rows().empty());
  EXPECT_TRUE(rise.roads().empty());
}

}  // namespace
}  // namespace hindsight
