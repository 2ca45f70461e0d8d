// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/color_cubes.h"

#include <algorithm>

namespace hindsight {
namespace {

constexpr float kMargin = 1e-3f;
constexpr std::uint32_t kLargeSide = 8, kSmallSide = 4;

/// Three bits to bit 0 of each channel: the reverse of put_low_bits_together.
constexpr std::uint32_t spread(std::uint32_t bits) {
  return (bits & 1u) | (bits & 2u) << 7 | (bits & 4u) << 14;
}

constexpr std::array<std::uint32_t, kFamily> kSpread{spread(0), spread(1), spread(2), spread(3),
                                                     spread(4), spread(5), spread(6), spread(7)};

/// The first colour of a cube.
constexpr std::uint32_t key_of_huge(std::uint32_t cube) {
  return (cube & 0xFu) << 4 | (cube & 0xF0u) << 8 | (cube & 0xF00u) << 12;
}
constexpr std::uint32_t key_of_large(std::uint32_t cube) {
  return key_of_huge(cube / kFamily) | spread(cube % kFamily) * kLargeSide;
}
constexpr std::uint32_t key_of_small(std::uint32_t cube) {
  return key_of_large(cube / kFamily) | spread(cube % kFamily) * kSmallSide;
}

constexpr float channel_of(std::uint32_t key, std::size_t k) {
  return static_cast<float>(key >> (16 - 8 * k) & 255u);
}

ColorBox rgb_box(std::uint32_t first_key, std::uint32_t side) {
  const float half = 0.5f * static_cast<float>(side - 1);
  ColorBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.middle[k] = channel_of(first_key, k) + half;
    box.half[k] = half + kMargin;
  }
  return box;
}

/// Eight cubes of a side of as many colours, the first colour of the first given.
ColorBoxes rgb_boxes(std::uint32_t first_key, std::uint32_t side) {
  const ColorBox first = rgb_box(first_key, side);
  ColorBoxes boxes;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::uint32_t i = 0; i < kFamily; ++i) {
      boxes.middle[k][i] = first.middle[k] + channel_of(spread(i) * side, k);
      boxes.half[k][i] = first.half[k];
    }
  }
  return boxes;
}

void put(ColorBoxes& boxes, std::size_t i, const ColorBox& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    boxes.middle[k][i] = box.middle[k];
    boxes.half[k][i] = box.half[k];
  }
}

ColorBox around(const ColorBoxes& boxes) {
  ColorBox whole;
  for (std::size_t k = 0; k < 3; ++k) {
    float low = 1e6f, high = -low;
    for (std::size_t i = 0; i < kFamily; ++i) {
      low = std::min(low, boxes.middle[k][i] - boxes.half[k][i]);
      high = std::max(high, boxes.middle[k][i] + boxes.half[k][i]);
    }
    whole.middle[k] = 0.5f * (low + high);
    whole.half[k] = 0.5f * (high - low);
  }
  return whole;
}

ColorBox measure(ColorSpace space, std::uint32_t small_cube) {
  float low[3] = {1e6f, 1e6f, 1e6f}, high[3] = {-1e6f, -1e6f, -1e6f};
  for (std::uint32_t octant = 0; octant < kFamily; ++octant) {
    OctantColors colors;
    find_colors(space, small_cube, octant, colors);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [least, most] = std::ranges::minmax(colors.channel[k]);
      low[k] = std::min(low[k], least);
      high[k] = std::max(high[k], most);
    }
  }
  ColorBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.middle[k] = 0.5f * (low[k] + high[k]);
    box.half[k] = 0.5f * (high[k] - low[k]) + kMargin;
  }
  return box;
}

}  // namespace

ColorBox ColorBoxes::one(std::size_t i) const {
  ColorBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.middle[k] = middle[k][i];
    box.half[k] = half[k][i];
  }
  return box;
}

void find_colors(ColorSpace space, std::uint32_t small_cube, std::uint32_t octant, OctantColors& colors) {
  const std::uint32_t first = key_of_small(small_cube) | spread(octant) << 1;
  for (std::uint32_t i = 0; i < kFamily; ++i) colors.key[i] = first | kSpread[i];
  if (space == ColorSpace::rgb) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < kFamily; ++i) colors.channel[k][i] = channel_of(colors.key[i], k);
    }
    return;
  }
  float* const out[3] = {colors.channel[0].data(), colors.channel[1].data(), colors.channel[2].data()};
  colors_of(space, colors.key.data(), kFamily, out);
}

ColorCubes::ColorCubes(ColorSpace space)
    : space_(space),
      small_ones_(space == ColorSpace::rgb ? 0 : kLargeCubes, ColorBoxes{}),
      large_ones_(space == ColorSpace::rgb ? 0 : kHugeCubes, ColorBoxes{}) {}

ColorBoxes ColorCubes::small_ones_in(std::uint32_t large_cube) {
  if (space_ == ColorSpace::rgb) return rgb_boxes(key_of_large(large_cube), kSmallSide);
  return measure_small_ones_in(large_cube);
}

ColorBoxes ColorCubes::large_ones_in(std::uint32_t huge_cube) {
  if (space_ == ColorSpace::rgb) return rgb_boxes(key_of_huge(huge_cube), kLargeSide);
  return measure_large_ones_in(huge_cube);
}

ColorBox ColorCubes::around_huge(std::uint32_t huge_cube) {
  if (space_ == ColorSpace::rgb) return rgb_box(key_of_huge(huge_cube), 2 * kLargeSide);
  return around(measure_large_ones_in(huge_cube));
}

const ColorBoxes& ColorCubes::measure_small_ones_in(std::uint32_t large_cube) {
  ColorBoxes& boxes = small_ones_[large_cube];
  if (boxes.half[0][0] != 0.0f) return boxes;
  for (std::uint32_t i = 0; i < kFamily; ++i) put(boxes, i, measure(space_, large_cube * kFamily + i));
  return boxes;
}

const ColorBoxes& ColorCubes::measure_large_ones_in(std::uint32_t huge_cube) {
  ColorBoxes& boxes = large_ones_[huge_cube];
  if (boxes.half[0][0] != 0.0f) return boxes;
  for (std::uint32_t i = 0; i < kFamily; ++i)
    put(boxes, i, around(measure_small_ones_in(huge_cube * kFamily + i)));
  return boxes;
}

}  // namespace hindsight
