// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/min_eigenvalue.h"

#include <algorithm>
#include <cmath>

#include "perception/gaussian_kernel.h"
#include "perception/multiversion.h"
#include "perception/simd.h"

namespace hindsight {
namespace {

constexpr int kMargin = 2;  // smoothed pixels needed beyond the image: one for the gradient, one for the sum
constexpr float kGradientUnit =
    8.0F * 32.0F;  // a Sobel sum over values in 1/32 grey, for one grey level / px

/// Half a kernel: the weight in the middle first.
using HalfKernel = std::array<std::uint16_t, MinEigenvalueRows::kMaxKernelPx / 2 + 1>;

HINDSIGHT_ALWAYS_INLINE std::uint16_t multiply_high(std::uint16_t a, std::uint16_t b) {
  return static_cast<std::uint16_t>((static_cast<std::uint32_t>(a) * b) >> 16);
}

/// sums[i] = the kernel down column i of `first`, times 128.
template <int kRadius>
HINDSIGHT_ALWAYS_INLINE void filter_columns(const std::uint8_t* first, std::ptrdiff_t stride,
                                            const HalfKernel& kernel, int count,
                                            std::uint16_t* __restrict sums) {
  for (int i = 0; i < count; ++i) {
    auto sum = static_cast<std::uint16_t>(kernel[0] * first[i]);
    for (int k = 1; k <= kRadius; ++k) {
      const int pair = first[i - k * stride] + first[i + k * stride];
      sum = static_cast<std::uint16_t>(sum + kernel[static_cast<std::size_t>(k)] * pair);
    }
    sums[i] = sum >> 1;
  }
}

/// out[i] = the kernel along the row around sums[i + kRadius], from 1/128 to 1/32 grey; its weights are in
/// 1/65536.
template <int kRadius>
HINDSIGHT_ALWAYS_INLINE void filter_row(const std::uint16_t* sums, const HalfKernel& weights, int count,
                                        std::int16_t* __restrict out) {
  for (int i = 0; i < count; ++i) {
    const std::uint16_t* s = sums + i + kRadius;
    std::uint16_t sum = multiply_high(s[0], weights[0]);
    for (int k = 1; k <= kRadius; ++k) {
      const auto pair = static_cast<std::uint16_t>(s[-k] + s[k]);
      sum = static_cast<std::uint16_t>(sum + multiply_high(pair, weights[static_cast<std::size_t>(k)]));
    }
    out[i] = static_cast<std::int16_t>(sum >> 2);
  }
}

/// Both ways, count pixels from `first` on. A radius known to the compiler keeps the sums in registers.
HINDSIGHT_MULTIVERSION
void smooth(const std::uint8_t* first, std::ptrdiff_t stride, const HalfKernel& kernel, int radius, int count,
            std::uint16_t* sums, std::int16_t* out) {
  HalfKernel weights{};  // in 1/65536; a kernel of one tap, 256, must fit
  std::ranges::transform(kernel, weights.begin(), [](std::uint16_t weight) {
    return static_cast<std::uint16_t>(std::min(weight << 8, 65535));
  });
  const auto filter = [&]<int kRadius>() __attribute__((always_inline)) {
    filter_columns<kRadius>(first - kRadius, stride, kernel, count + 2 * kRadius, sums);
    filter_row<kRadius>(sums, weights, count, out);
  };
  switch (radius) {
    case 0:
      return filter.template operator()<0>();
    case 1:
      return filter.template operator()<1>();
    case 2:
      return filter.template operator()<2>();
    case 3:
      return filter.template operator()<3>();
    case 4:
      return filter.template operator()<4>();
    case 5:
      return filter.template operator()<5>();
    case 6:
      return filter.template operator()<6>();
    default:
      return filter.template operator()<7>();
  }
}

/// Products of the Sobel gradients at count pixels; a, b, c are the smoothed rows above, at and below, one
/// pixel further left. Values up to 255 * 32 make gradients that just fit 16 bits.
HINDSIGHT_MULTIVERSION
void multiply_gradients_of_row(const std::int16_t* a, const std::int16_t* b, const std::int16_t* c, int count,
                               float* __restrict xx, float* __restrict xy, float* __restrict yy) {
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

/// out[i] = a[i] + b[i] + c[i].
HINDSIGHT_ALWAYS_INLINE void add_rows(const float* a, const float* b, const float* c, int count,
                                      float* __restrict out) {
  for (int i = 0; i < count; ++i) out[i] = (a[i] + b[i]) + c[i];
}

/// The sum of three neighbours, the first at s.
HINDSIGHT_ALWAYS_INLINE void sum3(const float* s, Floats& sum) {
  Floats second, third;
  load(sum, s), load(second, s + 1), load(third, s + 2);
  sum = (sum + second) + third;
}

/// Eigenvalues from the products' sums down each column; returns the largest. count >= kLanes.
HINDSIGHT_ALWAYS_INLINE float solve_pixels(const float* xx_sums, const float* xy_sums, const float* yy_sums,
                                           int count, float* values) {
  constexpr float kScale = 0.5F / (kGradientUnit * kGradientUnit);
  constexpr int kStep = static_cast<int>(kLanes);
  Floats largest{};
  for (int next = 0; next < count; next += kStep) {
    const int i = std::min(next, count - kStep);
    Floats xx, xy, yy;
    sum3(xx_sums + i, xx), sum3(xy_sums + i, xy), sum3(yy_sums + i, yy);
    const Floats difference = xx - yy;
    Floats root = difference * difference + 4.0F * xy * xy;
    for (std::size_t l = 0; l < kLanes; ++l) root[l] = __builtin_sqrtf(root[l]);
    const Floats value = kScale * ((xx + yy) - root);
    store(values + i, value);
    larger_of(largest, value);
  }
  return -least(-largest);
}

struct ProductRows {
  const float* xx[3];
  const float* xy[3];
  const float* yy[3];
};

/// sums: three rows of count + 2.
HINDSIGHT_MULTIVERSION
float solve_row_of(const ProductRows& p, int count, float* const sums[3], float* values) {
  add_rows(p.xx[0], p.xx[1], p.xx[2], count + 2, sums[0]);
  add_rows(p.xy[0], p.xy[1], p.xy[2], count + 2, sums[1]);
  add_rows(p.yy[0], p.yy[1], p.yy[2], count + 2, sums[2]);
  return solve_pixels(sums[0], sums[1], sums[2], count, values);
}

}  // namespace

MinEigenvalueRows::MinEigenvalueRows(int width_px, int height_px, int smoothing_kernel_px,
                                     double smoothing_sigma_px)
    : width_(static_cast<std::size_t>(width_px)),
      height_px_(height_px),
      radius_(smoothing_kernel_px / 2),
      kernel_(half_gaussian_256<kMaxKernelPx / 2 + 1>(radius_, smoothing_sigma_px)),
      column_sums_(width_ + 2 * kMargin + kMaxKernelPx) {
  for (auto& row : smooth_) row.resize(width_ + 2 * kMargin);
  for (auto* row : {&products_[0], &products_[1], &products_[2], &sums_}) {
    row->xx.resize(width_ + 2);
    row->xy.resize(width_ + 2);
    row->yy.resize(width_ + 2);
  }
  for (auto& row : values_) row.resize(width_);
}

void MinEigenvalueRows::begin(const GreyImage& grey) {
  largest_ = 0.0F;
  for (int y = -2; y <= 0; ++y) smooth_row(grey, y);
  multiply_gradients(-1);
  smooth_row(grey, 1);
  multiply_gradients(0);
}

void MinEigenvalueRows::advance(const GreyImage& grey, int y) {
  smooth_row(grey, y + 2);
  multiply_gradients(y + 1);
  solve_row(y);
}

void MinEigenvalueRows::smooth_row(const GreyImage& grey, int y) {
  smooth(grey.row(y) - kMargin, grey.stride(), kernel_, radius_, static_cast<int>(width_) + 2 * kMargin,
         column_sums_.data(), smoothed(y).data());
}

void MinEigenvalueRows::multiply_gradients(int y) {
  Products& out = products(y);
  multiply_gradients_of_row(smoothed(y - 1).data(), smoothed(y).data(), smoothed(y + 1).data(),
                            static_cast<int>(width_) + 2, out.xx.data(), out.xy.data(), out.yy.data());
}

void MinEigenvalueRows::solve_row(int y) {
  const Products &a = products(y - 1), &b = products(y), &c = products(y + 1);
  const ProductRows rows{{a.xx.data(), b.xx.data(), c.xx.data()},
                         {a.xy.data(), b.xy.data(), c.xy.data()},
                         {a.yy.data(), b.yy.data(), c.yy.data()}};
  float* const sums[3] = {sums_.xx.data(), sums_.xy.data(), sums_.yy.data()};
  const float largest =
      solve_row_of(rows, static_cast<int>(width_), sums, values_[static_cast<std::size_t>(y + 3) % 3].data());
  largest_ = std::max(largest_, largest);
}

}  // namespace hindsight
