// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "perception/grey_image.h"

namespace hindsight {

/// An image and its copies of half the size each, smoothed with a 5 x 5 Gaussian before each halving
/// (thesis 2.2). Pixel (x, y) of level l lies at (x, y) * 2^l of level 0.
class ImagePyramid {
 public:
  /// Makes fewer levels than asked for where the next would be smaller than 8 pixels on a side.
  ImagePyramid(int width_px, int height_px, int levels, double prefilter_sigma_px);

  /// Takes 8-bit BGR, width * height * 3 bytes without padding.
  void build(std::span<const std::uint8_t> bgr);

  int levels() const { return static_cast<int>(levels_.size()); }
  const GreyImage& level(int l) const { return levels_[static_cast<std::size_t>(l)]; }

 private:
  std::vector<GreyImage> levels_;
  std::array<std::uint16_t, 3> kernel_;  ///< half of the symmetric kernel, middle first, in 1/256
  std::vector<std::uint16_t> column_sums_;
};

}  // namespace hindsight
