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
/// Smoothing, gradients, sums and eigenvalues are one pass over the image that keeps a few rows at hand, so
/// that all of it stays in the processor's near cache.
class MinEigenvalueRows {
 public:
  static constexpr int kMaxKernelPx = 15;

  MinEigenvalueRows(int width_px, int height_px, int smoothing_kernel_px, double smoothing_sigma_px);

  /// Calls visit(y) for each row from the top as soon as row(y) and those above and below it are there.
  template <typename Visit>
  void compute(const GreyImage& grey, Visit&& visit) {
    begin(grey);
    for (int y = 0; y < height_px_; ++y) {
      advance(grey, y);
      if (y > 0) visit(y - 1);
    }
    visit(height_px_ - 1);
  }

  /// During visit(y): rows y - 1, y and y + 1, those that the image has.
  const float* row(int y) const { return values_[static_cast<std::size_t>(y + 3) % 3].data(); }
  /// Of the rows that have been there.
  float largest() const { return largest_; }

 private:
  struct Products {  // of the gradients along one row, from column -1 to width
    std::vector<float> xx, xy, yy;
  };
  void begin(const GreyImage& grey);
  void advance(const GreyImage& grey, int y);
  void smooth_row(const GreyImage& grey, int y);
  void multiply_gradients(int y);
  void solve_row(int y);
  std::vector<std::int16_t>& smoothed(int y) { return smooth_[static_cast<std::size_t>(y + 3) % 3]; }
  Products& products(int y) { return products_[static_cast<std::size_t>(y + 3) % 3]; }

  std::size_t width_;
  int height_px_;
  int radius_;
  std::array<std::uint16_t, kMaxKernelPx / 2 + 1> kernel_;
  std::vector<std::uint16_t> column_sums_;
  std::array<std::vector<std::int16_t>, 3>
      smooth_;                        ///< the last three smoothed rows, from column -2, in 1/32 grey
  std::array<Products, 3> products_;  ///< of the last three rows
  Products sums_;                     ///< of these, down each column
  std::array<std::vector<float>, 3> values_;
  float largest_ = 0.0F;
};

}  // namespace hindsight
