// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/corner_detector.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>

#include "perception/multiversion.h"

namespace hindsight {
namespace {

HINDSIGHT_ALWAYS_INLINE float larger(float a, float b) { return a > b ? a : b; }

/// out[i] = 1 where here[i] is above the threshold and none of its eight neighbours is larger. Rows are
/// readable from -1 to count.
HINDSIGHT_MULTIVERSION
void mark_local_maxima(const float* above, const float* here, const float* below, float threshold, int count,
                       std::uint8_t* out) {
  for (int i = 0; i < count; ++i) {
    const float sides = larger(here[i - 1], here[i + 1]);
    const float upper = larger(larger(above[i - 1], above[i]), above[i + 1]);
    const float lower = larger(larger(below[i - 1], below[i]), below[i + 1]);
    const float bound = larger(larger(sides, upper), lower);
    out[i] = static_cast<std::uint8_t>(here[i] >= bound) & static_cast<std::uint8_t>(here[i] > threshold);
  }
}

/// Positive floats order as their bits do; the complement of the place puts the upper left one first.
std::uint64_t candidate(float strength, std::uint32_t place) {
  return (static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(strength)) << 32) | ~place;
}
std::uint32_t place_of(std::uint64_t candidate) { return ~static_cast<std::uint32_t>(candidate); }

}  // namespace

CornerDetector::CornerDetector(const CornerParams& params, int width_px, int height_px)
    : params_(params),
      width_px_(width_px),
      height_px_(height_px),
      strength_(width_px, height_px, params.smoothing_kernel_px, params.smoothing_sigma_px) {
  const auto pixels = static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  is_maximum_.resize(static_cast<std::size_t>(width_px) + 8);
  candidates_.reserve(pixels);
  blocked_.resize(pixels);
  taken_in_cell_.resize(static_cast<std::size_t>(params.quota_columns) *
                        static_cast<std::size_t>(params.quota_rows));
  corners_.reserve(static_cast<std::size_t>(params.max_features));
  for (int dy = 0; dy < params.min_spacing_px; ++dy) {
    const double half = std::sqrt(params.min_spacing_px * params.min_spacing_px - dy * dy);
    disc_half_width_px_.push_back(static_cast<int>(std::ceil(half)) - 1);  // the circle itself is far enough
  }
}

std::span<const Point2f> CornerDetector::detect(const GreyImage& grey) {
  candidates_.clear();
  strength_.compute(grey, [this](int y) { collect_local_maxima(y); });
  select();
  return corners_;
}

float CornerDetector::threshold() const { return static_cast<float>(params_.quality) * strength_.largest(); }

/// The image's largest is not yet known: some of these are too weak.
void CornerDetector::collect_local_maxima(int y) {
  if (y == 0 || y == height_px_ - 1) return;
  const int inner = width_px_ - 2;  // the outermost pixels have no full neighbourhood
  const float* here = strength_.row(y) + 1;
  mark_local_maxima(strength_.row(y - 1) + 1, here, strength_.row(y + 1) + 1, threshold(), inner,
                    is_maximum_.data());
  for (int x = 0; x < inner; x += 8) {
    std::uint64_t eight;
    std::memcpy(&eight, is_maximum_.data() + x, sizeof(eight));
    for (; eight != 0; eight &= eight - 1) {
      const int i = x + std::countr_zero(eight) / 8;
      candidates_.push_back(candidate(here[i], static_cast<std::uint32_t>(y * width_px_ + i + 1)));
    }
  }
}

void CornerDetector::select() {
  const std::uint64_t weakest = candidate(threshold(), ~0U);
  std::erase_if(candidates_, [weakest](std::uint64_t c) { return c >> 32 <= weakest >> 32; });
  std::sort(candidates_.begin(), candidates_.end(), std::greater<>());
  std::fill(blocked_.begin(), blocked_.end(), std::uint8_t{0});
  std::fill(taken_in_cell_.begin(), taken_in_cell_.end(), 0);
  corners_.clear();
  for (const std::uint64_t c : candidates_) {
    const std::uint32_t place = place_of(c);
    if (blocked_[place] != 0) continue;
    const int x = static_cast<int>(place) % width_px_, y = static_cast<int>(place) / width_px_;
    if (!quota_left(x, y)) continue;
    block_around(x, y);
    corners_.push_back({static_cast<float>(x), static_cast<float>(y)});
    if (corners_.size() == static_cast<std::size_t>(params_.max_features)) return;
  }
}

bool CornerDetector::quota_left(int x, int y) {
  if (params_.quota_per_cell == 0) return true;
  const int column = x * params_.quota_columns / width_px_, row = y * params_.quota_rows / height_px_;
  int& taken = taken_in_cell_[static_cast<std::size_t>(row * params_.quota_columns + column)];
  if (taken == params_.quota_per_cell) return false;
  ++taken;
  return true;
}

void CornerDetector::block_around(int x, int y) {
  for (int dy = 0; dy < static_cast<int>(disc_half_width_px_.size()); ++dy) {
    const int half = disc_half_width_px_[static_cast<std::size_t>(dy)];
    const int left = std::max(x - half, 0), right = std::min(x + half, width_px_ - 1);
    const auto block_row = [&](int row) {
      if (row < 0 || row >= height_px_) return;
      std::uint8_t* p = blocked_.data() + static_cast<std::ptrdiff_t>(row) * width_px_;
      std::memset(p + left, 1, static_cast<std::size_t>(right - left + 1));
    };
    block_row(y - dy);
    block_row(y + dy);
  }
}

}  // namespace hindsight
