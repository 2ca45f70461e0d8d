// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/min_eigenvalue.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "perception/gaussian_kernel.h"
#include "perception/multiversion.h"

namespace hindsight {
namespace {

constexpr int kMargin = 2;  // smoothed pixels needed beyond the image: one for the gradient, one for the sum
constexpr float kGradientUnit =
    8.0F * 32.0F;  // a Sobel sum over values in 1/32 grey, for one grey level / px

/// sums[i] = the kernel down column i of `first`, times 256.
HINDSIGHT_MULTIVERSION
void filter_columns(const std::uint8_t* first, std::ptrdiff_t stride, const std::uint16_t* kernel, int radius,
                    int count, std::uint16_t* sums) {
  for (int i = 0; i < count; ++i) sums[i] = static_cast<std::uint16_t>(kernel[0] * first[i]);
  for (int k = 1; k <= radius; ++k) {
    const std::uint8_t* above = first - k * stride;
    const std::uint8_t* below = first + k * stride;
    const std::uint16_t weight = kernel[k];
    for (int i = 0; i < count; ++i) {
      const auto pair = static_cast<std::uint16_t>(above[i] + below[i]);
      sums[i] = static_cast<std::uint16_t>(sums[i] + weight * pair);
    }
  }
}

HINDSIGHT_ALWAYS_INLINE std::uint16_t multiply_high(std::uint16_t a, std::uint16_t b) {
  return static_cast<std::uint16_t>((static_cast<std::uint32_t>(a) * b) >> 16);
}

/// out[i] = the kernel along the row around sums[i + radius], from 1/256 to 1/32 grey.
HINDSIGHT_MULTIVERSION
void filter_row(const std::uint16_t* sums, const std::uint16_t* kernel, int radius, int count,
                std::uint16_t* scratch, std::int16_t* out) {
  std::memset(scratch, 0, static_cast<std::size_t>(count) * sizeof(*scratch));
  for (int k = -radius; k <= radius; ++k) {
    const std::uint16_t* s = sums + radius + k;
    const auto weight =
        static_cast<std::uint16_t>(kernel[k < 0 ? -k : k] << 7);  // a kernel of one tap, 256, must fit
    for (int i = 0; i < count; ++i)
      scratch[i] = static_cast<std::uint16_t>(scratch[i] + multiply_high(s[i], weight));
  }
  for (int i = 0; i < count; ++i) out[i] = static_cast<std::int16_t>(scratch[i] >> 2);
}

/// Products of the Sobel gradients at count pixels; a, b, c are the smoothed rows above, at and below, one
/// pixel further left. Values up to 255 * 32 make gradients that just fit 16 bits.
HINDSIGHT_MULTIVERSION
void multiply_gradients_of_row(const std::int16_t* a, const std::int16_t* b, const std::int16_t* c, int count,
                               float* xx, float* xy, float* yy) {
  for (int i = 0; i < count; ++i) {
    const auto gx = static_cast<std::int16_t>((a[i + 2] - a[i]) + 2 * (b[i + 2] - b[i]) + (c[i + 2] - c[i]));
    const auto gy =
        static_cast<std::int16_t>((c[i] - a[i]) + 2 * (c[i + 1] - a[i + 1]) + (c[i + 2] - a[i + 2]));
    const float fx = gx, fy = gy;
    xx[i] = fx * fx;
    xy[i] = fx * fy;
    yy[i] = fy * fy;
  }
}

HINDSIGHT_ALWAYS_INLINE float sum3x3(const float* a, const float* b, const float* c, int i) {
  return ((a[i] + b[i]) + c[i]) + ((a[i + 1] + b[i + 1]) + c[i + 1]) + ((a[i + 2] + b[i + 2]) + c[i + 2]);
}

struct ProductRows {
  const float* xx[3];
  const float* xy[3];
  const float* yy[3];
};

HINDSIGHT_MULTIVERSION
void solve_pixels(const ProductRows& p, int count, float* __restrict values,
                  float* __restrict column_largest) {
  constexpr float kScale = 0.5F / (kGradientUnit * kGradientUnit);
  for (int i = 0; i < count; ++i) {
    const float xx = sum3x3(p.xx[0], p.xx[1], p.xx[2], i);
    const float xy = sum3x3(p.xy[0], p.xy[1], p.xy[2], i);
    const float yy = sum3x3(p.yy[0], p.yy[1], p.yy[2], i);
    const float difference = xx - yy;
    const float root = __builtin_sqrtf(difference * difference + 4.0F * xy * xy);
    values[i] = kScale * ((xx + yy) - root);
    column_largest[i] = column_largest[i] > values[i] ? column_largest[i] : values[i];
  }
}

}  // namespace

MinEigenvalueMap::MinEigenvalueMap(int width_px, int height_px, int smoothing_kernel_px,
                                   double smoothing_sigma_px)
    : width_(static_cast<std::size_t>(width_px)),
      height_px_(height_px),
      radius_(smoothing_kernel_px / 2),
      kernel_(half_gaussian_256<kMaxKernelPx / 2 + 1>(radius_, smoothing_sigma_px)),
      column_sums_(width_ + 2 * kMargin + kMaxKernelPx),
      scratch_(width_ + 2 * kMargin),
      column_largest_(width_),
      values_(width_ * static_cast<std::size_t>(height_px)) {
  for (auto& row : smooth_) row.resize(width_ + 2 * kMargin);
  for (auto& row : products_) {
    row.xx.resize(width_ + 2);
    row.xy.resize(width_ + 2);
    row.yy.resize(width_ + 2);
  }
}

void MinEigenvalueMap::compute(const GreyImage& grey) {
  std::fill(column_largest_.begin(), column_largest_.end(), 0.0F);
  smooth_row(grey, -2);
  smooth_row(grey, -1);
  for (int y = -1; y <= height_px_; ++y) {
    smooth_row(grey, y + 1);
    multiply_gradients(y);
    if (y >= 1) solve_row(y - 1);
  }
  largest_ = *std::max_element(column_largest_.begin(), column_largest_.end());
}

void MinEigenvalueMap::smooth_row(const GreyImage& grey, int y) {
  const int count = static_cast<int>(width_) + 2 * kMargin;
  filter_columns(grey.row(y) - kMargin - radius_, grey.stride(), kernel_.data(), radius_, count + 2 * radius_,
                 column_sums_.data());
  filter_row(column_sums_.data(), kernel_.data(), radius_, count, scratch_.data(), smooth(y).data());
}

void MinEigenvalueMap::multiply_gradients(int y) {
  Products& out = products(y);
  multiply_gradients_of_row(smooth(y - 1).data(), smooth(y).data(), smooth(y + 1).data(),
                            static_cast<int>(width_) + 2, out.xx.data(), out.xy.data(), out.yy.data());
}

void MinEigenvalueMap::solve_row(int y) {
  const Products &a = products(y - 1), &b = products(y), &c = products(y + 1);
  const ProductRows rows{{a.xx.data(), b.xx.data(), c.xx.data()},
                         {a.xy.data(), b.xy.data(), c.xy.data()},
                         {a.yy.data(), b.yy.data(), c.yy.data()}};
  solve_pixels(rows, static_cast<int>(width_), values_.data() + static_cast<std::size_t>(y) * width_,
               column_largest_.data());
}

}  // namespace hindsight
