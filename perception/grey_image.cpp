// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/grey_image.h"

#include <cstring>

#include "perception/multiversion.h"

namespace hindsight {
namespace {

HINDSIGHT_MULTIVERSION
void convert_pixels(const std::uint8_t* bgr, std::uint8_t* grey, int count) {
  for (int i = 0; i < count; ++i) {
    const auto sum =
        static_cast<std::uint16_t>(29 * bgr[3 * i] + 150 * bgr[3 * i + 1] + 77 * bgr[3 * i + 2] + 128);
    grey[i] = static_cast<std::uint8_t>(sum >> 8);
  }
}

}  // namespace

GreyImage::GreyImage(int width_px, int height_px)
    : width_px_(width_px),
      height_px_(height_px),
      stride_(width_px + 2 * kBorderPx),
      pixels_(static_cast<std::size_t>(stride_ * (height_px + 2 * kBorderPx))) {}

void GreyImage::fill_border() {
  for (int y = 0; y < height_px_; ++y) {
    std::uint8_t* p = row(y);
    std::memset(p - kBorderPx, p[0], kBorderPx);
    std::memset(p + width_px_, p[width_px_ - 1], kBorderPx);
  }
  const auto bytes = static_cast<std::size_t>(stride_);
  for (int i = 1; i <= kBorderPx; ++i) {
    std::memcpy(row(-i) - kBorderPx, row(0) - kBorderPx, bytes);
    std::memcpy(row(height_px_ - 1 + i) - kBorderPx, row(height_px_ - 1) - kBorderPx, bytes);
  }
}

void bgr_to_grey(std::span<const std::uint8_t> bgr, GreyImage& grey) {
  const int width = grey.width_px();
  for (int y = 0; y < grey.height_px(); ++y) {
    convert_pixels(bgr.data() + static_cast<std::ptrdiff_t>(y) * width * 3, grey.row(y), width);
  }
  grey.fill_border();
}

}  // namespace hindsight
