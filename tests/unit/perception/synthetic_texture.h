// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace hindsight::test {

/// A smooth random texture that can be read at any point: a sum of plane waves.
class Texture {
 public:
  explicit Texture(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> angle(0.0, 2.0 * M_PI), wavelength(8.0, 60.0);
    for (int i = 0; i < 24; ++i) {
      const double direction = angle(random), k = 2.0 * M_PI / wavelength(random);
      waves_.push_back({k * std::cos(direction), k * std::sin(direction), angle(random)});
    }
  }
  double at(double x, double y) const {
    double sum = 128.0;
    for (const auto& w : waves_) sum += 14.0 * std::sin(w.kx * x + w.ky * y + w.phase);
    return sum;
  }

 private:
  struct Wave {
    double kx, ky, phase;
  };
  std::vector<Wave> waves_;
};

inline std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

/// 8-bit BGR, grey in all channels; `value(x, y)` gives the brightness of a pixel.
std::vector<std::uint8_t> draw(int width, int height, auto&& value) {
  std::vector<std::uint8_t> bgr;
  bgr.reserve(static_cast<std::size_t>(width * height * 3));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) bgr.insert(bgr.end(), 3, to_byte(value(x, y)));
  }
  return bgr;
}

}  // namespace hindsight::test
