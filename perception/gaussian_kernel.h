// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace hindsight {

/// One half of a sampled Gaussian of 2 * radius + 1 taps, the middle one first, in whole parts of 256: the
/// two-sided sum is exactly 256, so that an 8-bit image times the kernel fits 16 bits. Needs kTaps > radius;
/// the rest is zero.
template <std::size_t kTaps>
std::array<std::uint16_t, kTaps> half_gaussian_256(int radius, double sigma_px) {
  std::array<double, kTaps> weights{};
  double sum = 0.0;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(radius); ++i) {
    const double x = static_cast<double>(i) / sigma_px;
    weights[i] = std::exp(-0.5 * x * x);
    sum += i == 0 ? weights[i] : 2.0 * weights[i];
  }
  std::array<std::uint16_t, kTaps> half{};
  int tails = 0;
  for (std::size_t i = 1; i <= static_cast<std::size_t>(radius); ++i) {
    half[i] = static_cast<std::uint16_t>(std::lround(256.0 * weights[i] / sum));
    tails += 2 * half[i];
  }
  half[0] = static_cast<std::uint16_t>(256 - tails);
  return half;
}

}  // namespace hindsight
