// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/image_pyramid.h"

#include <algorithm>

#include "perception/gaussian_kernel.h"
#include "perception/multiversion.h"

namespace hindsight {
namespace {

constexpr int kSmallestSidePx = 8;
constexpr int kReach = 2;  // of the 5-tap kernel
using HalfKernel = std::array<std::uint16_t, 3>;

/// sums[i] = the kernel down column i - kReach, times 256.
HINDSIGHT_MULTIVERSION
void filter_columns(const std::uint8_t* middle, std::ptrdiff_t stride, const HalfKernel& k, int count,
                    std::uint16_t* sums) {
  const std::uint8_t* p = middle - kReach;
  for (int i = 0; i < count; ++i) {
    const auto near = static_cast<std::uint16_t>(p[i - stride] + p[i + stride]);
    const auto far = static_cast<std::uint16_t>(p[i - 2 * stride] + p[i + 2 * stride]);
    sums[i] = static_cast<std::uint16_t>(k[0] * p[i] + k[1] * near + k[2] * far);
  }
}

/// The kernel along the row, at every second pixel.
HINDSIGHT_MULTIVERSION
void filter_row_and_halve(const std::uint16_t* sums, const HalfKernel& k, int count, std::uint8_t* out) {
  const std::uint32_t k0 = k[0], k1 = k[1], k2 = k[2];
  for (int i = 0; i < count; ++i) {
    const std::uint16_t* s = sums + 2 * i;
    const std::uint32_t near = static_cast<std::uint32_t>(s[1]) + s[3];
    const std::uint32_t far = static_cast<std::uint32_t>(s[0]) + s[4];
    out[i] = static_cast<std::uint8_t>((k0 * s[2] + k1 * near + k2 * far + 32768U) >> 16);
  }
}

}  // namespace

ImagePyramid::ImagePyramid(int width_px, int height_px, int levels, double prefilter_sigma_px)
    : kernel_(half_gaussian_256<3>(kReach, prefilter_sigma_px)),
      column_sums_(static_cast<std::size_t>(width_px + 2 * kReach + 1)) {
  int width = width_px, height = height_px;
  for (int l = 0; l < levels; ++l) {
    if (l > 0 && std::min(width, height) < kSmallestSidePx) break;
    levels_.emplace_back(width, height);
    width = (width + 1) / 2;
    height = (height + 1) / 2;
  }
}

void ImagePyramid::build(std::span<const std::uint8_t> bgr) {
  bgr_to_grey(bgr, levels_[0]);
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    const GreyImage& fine = levels_[l - 1];
    GreyImage& coarse = levels_[l];
    for (int y = 0; y < coarse.height_px(); ++y) {
      filter_columns(fine.row(2 * y), fine.stride(), kernel_, 2 * coarse.width_px() + 2 * kReach - 1,
                     column_sums_.data());
      filter_row_and_halve(column_sums_.data(), kernel_, coarse.width_px(), coarse.row(y));
    }
    coarse.fill_border();
  }
}

}  // namespace hindsight
