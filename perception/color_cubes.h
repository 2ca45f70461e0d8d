// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The 2^24 colours as cubes of three sizes: 2^18 small ones of 4 x 4 x 4 colours, 2^15 large ones of 8 x 8 x
// 8, 2^12 huge ones of 16 x 16 x 16. The eight cubes in cube i of the next size are 8 i .. 8 i + 7.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "perception/color_space.h"

namespace hindsight {

constexpr std::size_t kSmallCubes = std::size_t{1} << 18;
constexpr std::size_t kLargeCubes = std::size_t{1} << 15;
constexpr std::size_t kHugeCubes = std::size_t{1} << 12;
constexpr std::uint32_t kFamily =
    8;  ///< cubes in one of the next size, and colours in an octant of a small one

/// Bits 0 and 1 of each channel of the colour b | g << 8 | r << 16, as b, g, r of bit 1 above b, g, r of bit
/// 0. Of a colour, or of each of a vector of them.
template <typename Keys>
constexpr void put_low_bits_together(const Keys& key, Keys& bits) {
  const Keys apart = (key & 0x010101u) | (key & 0x020202u) << 2;
  bits = (apart | apart >> 7 | apart >> 14) & 63u;
}
template <typename Keys>
constexpr void find_small_cube(const Keys& key, Keys& cube) {
  put_low_bits_together(Keys(key >> 2), cube);
  cube |= (key << 2 & 0x3C0u) | (key >> 2 & 0x3C00u) | (key >> 6 & 0x3C000u);
}
/// Place of a colour in its small cube, 0..63: its octant of 2 x 2 x 2 colours, then the place in that.
constexpr std::uint32_t place_in_small_cube(std::uint32_t key) {
  std::uint32_t place = 0;
  put_low_bits_together(key, place);
  return place;
}

/// Box in a colour space: |c - middle| <= half in each channel.
struct ColorBox {
  float middle[3], half[3];
};
/// Those of the eight cubes in one of the next size.
struct ColorBoxes {
  float middle[3][kFamily], half[3][kFamily];

  ColorBox one(std::size_t i) const;
};

/// The colours of an octant by place, as bytes and in a colour space.
struct OctantColors {
  std::array<std::uint32_t, kFamily> key;  ///< b | g << 8 | r << 16
  std::array<std::array<float, kFamily>, 3> channel;
};
void find_colors(ColorSpace space, std::uint32_t small_cube, std::uint32_t octant, OctantColors& colors);

/// The smallest boxes that hold cubes in a colour space, wider by more than the floats' error. Those of a
/// curved space take long, and are remembered. Not thread safe.
class ColorCubes {
 public:
  explicit ColorCubes(ColorSpace space);

  ColorBoxes small_ones_in(std::uint32_t large_cube);
  ColorBoxes large_ones_in(std::uint32_t huge_cube);
  ColorBox around_huge(std::uint32_t huge_cube);

 private:
  const ColorBoxes& measure_small_ones_in(std::uint32_t large_cube);
  const ColorBoxes& measure_large_ones_in(std::uint32_t huge_cube);

  ColorSpace space_;
  std::vector<ColorBoxes> small_ones_;  ///< by large cube; half[0][0] is 0 where not yet measured
  std::vector<ColorBoxes> large_ones_;  ///< by huge cube, likewise
};

}  // namespace hindsight
