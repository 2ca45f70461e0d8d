// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The 2^24 colours as cubes: 2^18 small ones of 4 x 4 x 4 colours, and 2^15 large ones of 2 x 2 x 2 of those.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "perception/color_space.h"

namespace hindsight {

constexpr std::size_t kSmallCubes = std::size_t{1} << 18;
constexpr std::size_t kLargeCubes = std::size_t{1} << 15;
constexpr std::size_t kColorsInSmallCube = 64;

/// Of the colour b | g << 8 | r << 16: the high six bits of each channel.
constexpr std::uint32_t small_cube_of(std::uint32_t key) {
  return (key >> 2 & 0x3Fu) | (key >> 4 & 0xFC0u) | (key >> 6 & 0x3F000u);
}
/// Place of a colour in its small cube, 0..63: the low two bits of each channel. The product moves them
/// together.
constexpr std::uint32_t place_in_small_cube(std::uint32_t key) {
  return (key & 0x030303u) * 0x10410u >> 16 & 63u;
}
/// Of a small cube: the high five bits of each channel.
constexpr std::uint32_t large_cube_of(std::uint32_t small_cube) {
  return (small_cube >> 1 & 0x1Fu) | (small_cube >> 2 & 0x3E0u) | (small_cube >> 3 & 0x7C00u);
}
/// Box in a colour space: |c - middle| <= half in each channel.
struct ColorBox {
  float middle[3], half[3];
};

/// The colours of a small cube by place_in_small_cube, as bytes and in a colour space.
struct CubeColors {
  std::array<std::uint32_t, kColorsInSmallCube> key;  ///< b | g << 8 | r << 16
  std::array<std::array<float, kColorsInSmallCube>, 3> channel;
};
void find_colors(ColorSpace space, std::uint32_t small_cube, CubeColors& colors);

/// The smallest boxes that hold the small cubes in a colour space, wider by more than the floats' error.
/// Not thread safe.
class ColorCubes {
 public:
  explicit ColorCubes(ColorSpace space);

  ColorBox around_small(std::uint32_t small_cube);
  ColorBox around_large(std::uint32_t large_cube);

 private:
  ColorBox measure(std::uint32_t small_cube) const;

  ColorSpace space_;
  std::vector<ColorBox>
      known_;  ///< of a curved space, where they take long; half[0] is 0 where not yet known
};

}  // namespace hindsight
