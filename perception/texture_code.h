// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Texture in one byte a pixel: how much grey changes from pixel to pixel around it, across and down. Bark is
// ridged across, litter is rough both ways, a shaded path is smooth: colours that bark and ground share are
// told apart by it. It changes with distance, so it must be learned from afar as well as from nearby
// (reverse flow).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace hindsight {

constexpr int kTextureLevels = 8;
constexpr int kTextureCodes = kTextureLevels * kTextureLevels;

/// Of the pixel at column x, row y of a picture (row-major, three bytes a pixel (b, g, r)): kTextureLevels
/// times the level across plus the level down. A level is the mean absolute difference of neighbouring
/// greys, (b + 2 g + r) / 4, in the 5 x 5 pixels around it, in steps of half an octave from 0.8 to 20.6.
/// Beyond its border the picture is taken to go on as it ends.
std::uint8_t texture_code_at(std::span<const std::uint8_t> bgr, int width_px, int height_px, int x, int y);

/// The same of every pixel at once. One thread.
class TextureMap {
 public:
  /// Both sides at least 1.
  TextureMap(int width_px, int height_px);

  /// `bgr` has the size given at construction. The codes, row-major, are valid until the next call. No
  /// allocation.
  std::span<const std::uint8_t> update(std::span<const std::uint8_t> bgr);

 private:
  void find_greys(std::span<const std::uint8_t> bgr);
  void find_differences(int y);
  void code_row(int y);

  int width_px_;
  int height_px_;
  std::size_t stride_;                        ///< of a row with its margins
  std::vector<std::uint8_t> grey_;            ///< with a margin all around that repeats the border
  std::vector<std::uint16_t> across_, down_;  ///< of one row: a column's differences in five rows
  std::vector<std::uint8_t> codes_;
};

}  // namespace hindsight
