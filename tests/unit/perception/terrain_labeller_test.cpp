// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/terrain_labeller.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace hindsight {
namespace {

constexpr auto kGood = TerrainClass::good, kBad = TerrainClass::bad, kLethal = TerrainClass::lethal,
               kUnknown = TerrainClass::unknown;
using Labels = std::vector<TerrainClass>;

TEST(BoxSum, EqualsSummingEachWindow) {
  std::mt19937 random(1);
  for (const auto& [columns, rows, radius] :
       {std::tuple{1, 1, 0}, {1, 1, 3}, {5, 7, 1}, {20, 9, 4}, {6, 30, 12}, {33, 17, 2}}) {
    BoxSum<std::int32_t> sum(columns, rows, radius);
    for (int round = 0; round < 2; ++round) {
      for (std::int32_t& v : sum.in()) v = static_cast<std::int32_t>(random() % 2001) - 1000;
      sum.update();
      for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
          std::int32_t expected = 0;
          for (int v = std::max(0, y - radius); v <= std::min(rows - 1, y + radius); ++v)
            for (int u = std::max(0, x - radius); u <= std::min(columns - 1, x + radius); ++u)
              expected += sum.in()[static_cast<std::size_t>(v * columns + u)];
          ASSERT_EQ(sum.out()[static_cast<std::size_t>(y * columns + x)], expected);
        }
      }
    }
  }
}

std::vector<std::uint8_t> small_noise(std::mt19937& random, int cells) {
  std::vector<std::uint8_t> bgr(static_cast<std::size_t>(3 * cells));
  for (std::uint8_t& v : bgr) v = static_cast<std::uint8_t>(random() % 30);
  return bgr;
}

/// What the header says, pixel by pixel.
TerrainClass by_hand(const LabelParams& params, const Labels& colors, int width, int height, int cell_px,
                     std::span<const std::uint8_t> small_bgr, const TextureModel& texture, int x, int y) {
  const int columns = width / cell_px, rows = height / cell_px, radius = params.window_px / cell_px / 2;
  const int cx = std::min(x / cell_px, columns - 1), cy = std::min(y / cell_px, rows - 1);
  double evidence = 0.0, known = 0.0, severity = 0.0;
  int cells = 0;
  const TextureLogRatios ratios = texture.log_ratios(params.texture_limit);
  for (int v = std::max(0, cy - radius); v <= std::min(rows - 1, cy + radius); ++v) {
    for (int u = std::max(0, cx - radius); u <= std::min(columns - 1, cx + radius); ++u) {
      ++cells;
      if (params.texture) evidence += ratios[texture_code_at(small_bgr, columns, rows, u, v)];
      for (int k = 0; k < cell_px * cell_px; ++k) {
        const auto label =
            colors[static_cast<std::size_t>((v * cell_px + k / cell_px) * width + u * cell_px + k % cell_px)];
        const double each = params.color_log_ratio / (cell_px * cell_px);
        evidence += label == kGood ? -each : label == kUnknown ? 0.0 : each;
        known += label != kUnknown;
        severity += label == kLethal ? 1 : label == kBad ? -1 : 0;
      }
    }
  }
  const double judged = params.texture ? cells : known / (cell_px * cell_px);
  if (known == 0 || judged < 0.3 * cells) return kUnknown;
  if (evidence < -params.obstacle_log_odds * judged) return kGood;
  return severity >= 0 ? kLethal : kBad;
}

TEST(TerrainLabeller, EqualsTheDefinitionOnNoise) {
  std::mt19937 random(2);
  TextureModel texture;
  std::vector<std::uint8_t> codes(100);
  for (const auto label : {kGood, kBad, kLethal}) {
    for (std::uint8_t& code : codes) code = static_cast<std::uint8_t>(random() % kTextureCodes);
    texture.train(codes, label);
  }
  for (const int cell_px : {1, 2, 4}) {
    for (const int window_px : {2, 10, 21}) {
      LabelParams params;
      params.window_px = window_px;
      params.texture = window_px != 21;
      const int width = 43, height = 22;
      TerrainLabeller labeller(params, width, height, cell_px);
      for (const unsigned kinds : {2u, 4u}) {
        Labels colors(static_cast<std::size_t>(width * height));
        for (TerrainClass& label : colors)
          label = static_cast<TerrainClass>(random() % kinds + (kinds == 2u ? 2 : 0));
        const auto small = small_noise(random, (width / cell_px) * (height / cell_px));
        const auto labels = labeller.label(colors, small, texture);
        int differ = 0;
        for (int i = 0; i < width * height; ++i) {
          differ += labels[static_cast<std::size_t>(i)] !=
                    by_hand(params, colors, width, height, cell_px, small, texture, i % width, i / width);
        }
        EXPECT_LE(differ, width * height / 100) << cell_px << ' ' << window_px << ": but for roundings";
      }
    }
  }
}

TEST(TerrainLabeller, WithoutAWindowColorsDecide) {
  LabelParams params;
  params.window_px = 0;
  TerrainLabeller labeller(params, 4, 2, 2);
  const Labels colors{kGood, kBad, kLethal, kUnknown, kGood, kBad, kLethal, kUnknown};
  EXPECT_TRUE(std::ranges::equal(labeller.label(colors, {}, TextureModel{}), colors));
}

TEST(TerrainLabeller, SpecksGoAndThingsStay) {
  std::mt19937 random(3);
  const int width = 120, height = 80;
  Labels colors(static_cast<std::size_t>(width * height), kGood);
  for (TerrainClass& label : colors)
    if (random() % 5 == 0) label = kLethal;
  for (int y = 20; y < 60; ++y)
    for (int x = 50; x < 70; ++x)
      colors[static_cast<std::size_t>(y * width + x)] = random() % 5 == 0 ? kGood : kBad;
  LabelParams params;
  params.obstacle_log_odds = 0.0;
  TerrainLabeller labeller(params, width, height, 2);
  const std::vector<std::uint8_t> small(static_cast<std::size_t>(3 * width * height / 4), 100);
  const auto labels = labeller.label(colors, small, TextureModel{});
  const auto at = [&](int x, int y) { return labels[static_cast<std::size_t>(y * width + x)]; };
  for (int y = 25; y < 55; ++y)
    for (int x = 55; x < 65; ++x) EXPECT_EQ(at(x, y), kBad);
  int left = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < 40; ++x) left += at(x, y) != kGood;
  EXPECT_LT(left, 40 * height / 100);
}

TEST(TerrainLabeller, CallsNothingAnObstacleBeforeObstaclesAreKnown) {
  std::mt19937 random(4);
  const int width = 60, height = 40;
  TextureModel ground_alone;
  ground_alone.train(std::vector<std::uint8_t>{1, 2, 3}, kGood);
  const auto small = small_noise(random, width * height / 4);
  TerrainLabeller labeller(LabelParams{}, width, height, 2);
  for (const unsigned unknown_of_ten : {1u, 5u, 9u}) {
    Labels colors(static_cast<std::size_t>(width * height));
    for (TerrainClass& label : colors) label = random() % 10 < unknown_of_ten ? kUnknown : kGood;
    for (const TerrainClass label : labeller.label(colors, small, ground_alone))
      EXPECT_EQ(label, unknown_of_ten == 9 ? kUnknown : kGood) << unknown_of_ten;
  }
}

TEST(TerrainLabeller, TextureTellsWhatColorsDoNot) {
  const int width = 80, height = 40;
  TextureModel texture;
  const std::vector<std::uint8_t> smooth{0}, ridged{7 * kTextureLevels};
  texture.train(smooth, kGood);
  texture.train(ridged, kLethal);
  // Left half smooth, right half ridged, and all of it called good by its colour.
  std::vector<std::uint8_t> small;
  for (int y = 0; y < height / 2; ++y)
    for (int x = 0; x < width / 2; ++x)
      small.insert(small.end(), 3, static_cast<std::uint8_t>(x < width / 4 ? 90 : 90 + x % 2 * 40));
  const Labels colors(static_cast<std::size_t>(width * height), kGood);
  TerrainLabeller labeller(LabelParams{}, width, height, 2);
  const auto labels = labeller.label(colors, small, texture);
  EXPECT_EQ(labels[20 * width + 10], kGood);
  EXPECT_EQ(labels[20 * width + 70], kLethal);
  LabelParams without;
  without.texture = false;
  TerrainLabeller colors_only(without, width, height, 2);
  EXPECT_EQ(colors_only.label(colors, small, texture)[20 * width + 70], kGood);
}

}  // namespace
}  // namespace hindsight
