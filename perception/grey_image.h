// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hindsight {

/// 8-bit grey image with a border of copies of its outermost pixels, so that windows may hang over its edges.
class GreyImage {
 public:
  static constexpr int kBorderPx = 32;

  GreyImage(int width_px, int height_px);

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }
  std::ptrdiff_t stride() const { return stride_; }

  /// Pixel (0, y); columns and rows from -kBorderPx to size + kBorderPx - 1 may be read.
  const std::uint8_t* row(int y) const { return pixels_.data() + offset(y); }
  std::uint8_t* row(int y) { return pixels_.data() + offset(y); }

  /// To be called after the rows were written.
  void fill_border();

 private:
  std::size_t offset(int y) const { return static_cast<std::size_t>((y + kBorderPx) * stride_ + kBorderPx); }
  int width_px_;
  int height_px_;
  std::ptrdiff_t stride_;
  std::vector<std::uint8_t> pixels_;
};

/// Luma of 8-bit BGR (ITU-R BT.601, weights in 1/256), border filled. `bgr` holds width * height * 3 bytes.
void bgr_to_grey(std::span<const std::uint8_t> bgr, GreyImage& grey);

}  // namespace hindsight
