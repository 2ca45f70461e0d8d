// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "perception/grey_image.h"

namespace hindsight {

/// The smaller eigenvalue of the gradient matrix [[Sum Ex^2, Sum Ex Ey], [Sum Ex Ey, Sum Ey^2]] at each pixel
/// of the smoothed image (thesis 2.1): Sobel gradients, summed over 3 x 3 pixels, in (grey levels / px)^2.
/// Smoothing, gradients, sums and eigenvalues are one pass over the image that keeps a few rows at hand.
class MinEigenvalueMap {
 public:
  static constexpr int kMaxKernelPx = 15;

  MinEigenvalueMap(int width_px, int height_px, int smoothing_kernel_px, double smoothing_sigma_px);

  void compute(const GreyImage& grey);

  const float* row(int y) const { return values_.data() + static_cast<std::size_t>(y) * width_; }
  float largest() const { return largest_; }

 private:
  struct Products {  // of the gradients along one row, from column -1 to width
    std::vector<float> xx, xy, yy;
  };
  void smooth_row(const GreyImage& grey, int y);
  void multiply_gradients(int y);
  void solve_row(int y);
  std::vector<std::int16_t>& smooth(int y) { return smooth_[static_cast<std::size_t>(y + 3) % 3]; }
  Products& products(int y) { return products_[static_cast<std::size_t>(y + 3) % 3]; }

  std::size_t width_;
  int height_px_;
  int radius_;
  std::array<std::uint16_t, kMaxKernelPx / 2 + 1> kernel_;
  std::vector<std::uint16_t> column_sums_;
  std::vector<std::uint16_t> scratch_;
  std::array<std::vector<std::int16_t>, 3>
      smooth_;                        ///< the last three smoothed rows, from column -2, in 1/32 grey
  std::array<Products, 3> products_;  ///< of the last three rows
  std::vector<float> column_largest_;
  std::vector<float> values_;
  float largest_ = 0.0F;
};

}  // namespace hindsight
