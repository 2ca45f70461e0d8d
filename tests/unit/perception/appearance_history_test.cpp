// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/appearance_history.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "config/exit_code.h"

namespace hindsight {
namespace {

using Picture = std::vector<std::uint8_t>;

Picture random_picture(int width_px, int height_px, std::mt19937& random) {
  Picture picture(static_cast<std::size_t>(width_px * height_px * 3));
  for (auto& byte : picture) byte = static_cast<std::uint8_t>(random());
  return picture;
}

int at(const Picture& picture, int width_px, int x, int y, int channel) {
  return picture[static_cast<std::size_t>((y * width_px + x) * 3 + channel)];
}

/// Rounded mean of a box, one value at a time.
int box_mean(const Picture& picture, int width_px, int x, int y, int channel, int side) {
  int sum = 0;
  for (int dy = 0; dy < side; ++dy)
    for (int dx = 0; dx < side; ++dx) sum += at(picture, width_px, x * side + dx, y * side + dy, channel);
  return (sum + side * side / 2) / (side * side);
}

TEST(AppearanceHistory, KeepsTheLastPicturesShrunk) {
  std::mt19937 random(4);                           // seed 4
  const int kWidth = 37, kHeight = 22, kDepth = 5;  // no multiples of 2 or 4
  for (const int shrink : {1, 2, 4}) {
    AppearanceHistory history({shrink}, kDepth, kWidth, kHeight);
    std::vector<Picture> pictures;
    for (int n = 0; n < 13; ++n) {
      pictures.push_back(random_picture(kWidth, kHeight, random));
      history.push(pictures.back());
      ASSERT_EQ(history.size(), std::min(n + 1, kDepth));
      for (int back = 0; back < history.size(); ++back) {
        const Picture& full = pictures[static_cast<std::size_t>(n - back)];
        for (int y = 0; y < kHeight / shrink; ++y) {
          for (int x = 0; x < kWidth / shrink; ++x) {
            const Bgr pixel = history.stored(back, y * history.stored_width_px() + x);
            for (int c = 0; c < 3; ++c)
              ASSERT_EQ(pixel[static_cast<std::size_t>(c)], box_mean(full, kWidth, x, y, c, shrink))
                  << shrink;
          }
        }
      }
    }
  }
}

TEST(AppearanceHistory, PointsFallIntoThePixelThatShowsThem) {
  AppearanceHistory history({2}, 3, 10, 8);
  EXPECT_EQ(history.stored_index({-0.5, -0.5}), 0);
  EXPECT_EQ(history.stored_index({1.49, 1.49}), 0);
  EXPECT_EQ(history.stored_index({1.5, 0}), 1);
  EXPECT_EQ(history.stored_index({0, 1.5}), 5);
  EXPECT_EQ(history.stored_index({9.49, 7.49}), 19);
  EXPECT_EQ(history.stored_index({9.5, 0}), -1);
  EXPECT_EQ(history.stored_index({0, 7.5}), -1);
  EXPECT_EQ(history.stored_index({-0.51, 0}), -1);
  EXPECT_EQ(history.stored_index({1e30, 0}), -1);
}

TEST(AppearanceHistory, CollectsARegionOnce) {
  std::mt19937 random(9);  // seed 9
  AppearanceHistory history({2}, 3, 12, 8);
  const Picture old = random_picture(12, 8, random);
  history.push(old);
  history.push(random_picture(12, 8, random));
  std::vector<Bgr> pixels;
  history.collect(1, {3, 2, 4, 2}, pixels);  // columns 3..6 touch stored columns 1..3, rows 2..3 stored row 1
  ASSERT_EQ(pixels.size(), 3U);
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(pixels[static_cast<std::size_t>(k)][1], box_mean(old, 12, 1 + k, 1, 1, 2));

  pixels.clear();
  history.collect(0, {-100, -100, 1000, 1000}, pixels);
  EXPECT_EQ(pixels.size(), 24U) << "clipped to the picture";
  history.collect(2, {0, 0, 12, 8}, pixels);
  history.collect(-1, {0, 0, 12, 8}, pixels);
  history.collect(0, {20, 20, 5, 5}, pixels);
  EXPECT_EQ(pixels.size(), 24U) << "nothing there";
}

TEST(AppearanceHistory, ForgetsWhenCleared) {
  std::mt19937 random(9);
  AppearanceHistory history({1}, 3, 4, 4);
  const Picture picture = random_picture(4, 4, random);
  history.push(picture);
  EXPECT_TRUE(std::ranges::equal(history.picture(0), picture));
  history.clear();
  EXPECT_EQ(history.size(), 0);
  EXPECT_TRUE(history.picture(0).empty());
}

TEST(AppearanceHistory, OtherShrinksAreRefused) {
  try {
    AppearanceHistory history({3}, 3, 12, 8);
    FAIL();
  } catch (const FatalError& error) {
    EXPECT_EQ(error.code(), kExitConfiguration);
  }
}

}  // namespace
}  // namespace hindsight
