// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/label_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "config/exit_code.h"

namespace hindsight {
namespace {

using Labels = std::vector<TerrainClass>;

/// The definition, pixel by pixel.
Labels brute_force(const Labels& labels, int width, int height, const LabelFilterParams& params) {
  const int r = params.window_px / 2;
  const auto at = [&](int x, int y) {
    return labels[static_cast<std::size_t>(std::clamp(y, 0, height - 1) * width +
                                           std::clamp(x, 0, width - 1))];
  };
  const auto hazard = [](TerrainClass l) { return l == TerrainClass::bad || l == TerrainClass::lethal; };
  Labels out;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      int bad = 0, lethal = 0;
      for (int dy = -r; dy <= r; ++dy) {
        for (int dx = -r; dx <= r; ++dx) {
          bad += at(x + dx, y + dy) == TerrainClass::bad;
          lethal += at(x + dx, y + dy) == TerrainClass::lethal;
        }
      }
      const double share = static_cast<double>(bad + lethal) / (params.window_px * params.window_px);
      const TerrainClass alone = hazard(at(x, y)) ? TerrainClass::unknown : at(x, y);
      out.push_back(share >= params.share - 1e-12 ? (lethal >= bad ? TerrainClass::lethal : TerrainClass::bad)
                                                  : alone);
    }
  }
  return out;
}

TEST(LabelFilter, EqualsItsDefinition) {
  std::mt19937 random(20261128);
  for (const LabelFilterParams params : {LabelFilterParams{3, 0.5}, LabelFilterParams{9, 0.4},
                                         LabelFilterParams{15, 1.0}, LabelFilterParams{5, 0.01}}) {
    for (const auto& [width, height] : {std::pair{37, 23}, std::pair{4, 3}}) {
      Labels labels(static_cast<std::size_t>(width * height));
      const auto often = 1 + random() % 6;
      for (TerrainClass& label : labels)
        label = random() % often ? TerrainClass::lethal : static_cast<TerrainClass>(random() % 4);
      LabelFilter filter(params, width, height);
      const auto smoothed = filter.smooth(labels);
      EXPECT_TRUE(std::ranges::equal(smoothed, brute_force(labels, width, height, params)))
          << params.window_px << " px, " << width << " x " << height;
      EXPECT_TRUE(std::ranges::equal(filter.smooth(labels), brute_force(labels, width, height, params)))
          << "again";
    }
  }
}

TEST(LabelFilter, OnePixelWindowChangesNothing) {
  const Labels labels{TerrainClass::good, TerrainClass::lethal, TerrainClass::unknown, TerrainClass::bad};
  LabelFilter filter({1, 0.4}, 2, 2);
  EXPECT_TRUE(std::ranges::equal(filter.smooth(labels), labels));
}

TEST(LabelFilter, AnEvenWindowIsRefused) {
  try {
    const LabelFilter filter({4, 0.4}, 8, 8);
    FAIL();
  } catch (const FatalError& error) {
    EXPECT_EQ(error.code(), kExitConfiguration);
  }
}

}  // namespace
}  // namespace hindsight
