// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/color_cubes.h"

#include <algorithm>

namespace hindsight {
namespace {

constexpr float kMargin = 1e-3f;
constexpr int kSide = 4;

/// The first byte of each channel, in the order of the cube's bits: b, g, r.
constexpr std::uint32_t first_key(std::uint32_t small_cube) {
  return (small_cube & 0x3Fu) << 2 | (small_cube & 0xFC0u) << 4 | (small_cube & 0x3F000u) << 6;
}

constexpr ColorBox rgb_box(std::uint32_t key, float side) {
  const float half = 0.5f * (side - 1.0f);
  const auto middle = [&](int shift) { return static_cast<float>(key >> shift & 255u) + half; };
  return {{middle(16), middle(8), middle(0)}, {half + kMargin, half + kMargin, half + kMargin}};
}

/// The eight small cubes of a large one.
constexpr std::array<std::uint32_t, 8> small_cubes_in(std::uint32_t large_cube) {
  const std::uint32_t first =
      (large_cube & 0x1Fu) << 1 | (large_cube & 0x3E0u) << 2 | (large_cube & 0x7C00u) << 3;
  return {first,           first + 1,       first + 0x40,    first + 0x41,
          first + 0x1000u, first + 0x1001u, first + 0x1040u, first + 0x1041u};
}

}  // namespace

void find_colors(ColorSpace space, std::uint32_t small_cube, CubeColors& colors) {
  for (std::uint32_t i = 0; i < kColorsInSmallCube; ++i)
    colors.key[i] = first_key(small_cube) + ((i & 3u) | (i & 12u) << 6 | (i & 48u) << 12);
  float* const out[3] = {colors.channel[0].data(), colors.channel[1].data(), colors.channel[2].data()};
  colors_of(space, colors.key.data(), kColorsInSmallCube, out);
}

ColorCubes::ColorCubes(ColorSpace space)
    : space_(space), known_(space == ColorSpace::rgb ? 0 : kSmallCubes, ColorBox{}) {}

ColorBox ColorCubes::around_small(std::uint32_t small_cube) {
  if (space_ == ColorSpace::rgb) return rgb_box(first_key(small_cube), kSide);
  ColorBox& box = known_[small_cube];
  if (box.half[0] == 0.0f) box = measure(small_cube);
  return box;
}

ColorBox ColorCubes::around_large(std::uint32_t large_cube) {
  const std::array<std::uint32_t, 8> parts = small_cubes_in(large_cube);
  if (space_ == ColorSpace::rgb) return rgb_box(first_key(parts[0]), 2 * kSide);
  ColorBox whole{};
  for (int k = 0; k < 3; ++k) {
    float low = 1e6f, high = -low;
    for (const std::uint32_t part : parts) {
      const ColorBox box = around_small(part);
      low = std::min(low, box.middle[k] - box.half[k]);
      high = std::max(high, box.middle[k] + box.half[k]);
    }
    whole.middle[k] = 0.5f * (low + high);
    whole.half[k] = 0.5f * (high - low);
  }
  return whole;
}

ColorBox ColorCubes::measure(std::uint32_t small_cube) const {
  CubeColors colors;
  find_colors(space_, small_cube, colors);
  ColorBox box{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] = std::ranges::minmax(colors.channel[k]);
    box.middle[k] = 0.5f * (low + high);
    box.half[k] = 0.5f * (high - low) + kMargin;
  }
  return box;
}

}  // namespace hindsight
