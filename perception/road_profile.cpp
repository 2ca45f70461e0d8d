// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_profile.h"

#include <algorithm>

namespace hindsight {

RoadProfile::RoadProfile(int rows, int width_px)
    : width_px_(width_px), sums_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(width_px + 1)) {}

void RoadProfile::fill(int index, const RoadColors& colors, const ColorView& picture, int top_px,
                       int bottom_px) {
  float* sums = &sums_[static_cast<std::size_t>(index) * static_cast<std::size_t>(width_px_ + 1)];
  std::fill(sums, sums + width_px_ + 1, 0.0F);
  for (int row = top_px; row < bottom_px; ++row) {
    const std::uint8_t* pixel = picture.pixel(0, row);
    for (int column = 0; column < width_px_; ++column, pixel += 3)
      sums[column + 1] += colors.likelihood(pixel);
  }
  const float share = 1.0F / static_cast<float>(bottom_px - top_px);
  for (int column = 0; column < width_px_; ++column)
    sums[column + 1] = sums[column] + share * sums[column + 1];
}

float RoadProfile::between(int index, float left_px, float right_px) const {
  const float* sums = &sums_[static_cast<std::size_t>(index) * static_cast<std::size_t>(width_px_ + 1)];
  const auto width = static_cast<float>(width_px_);
  const float left = std::clamp(left_px, 0.0F, width), right = std::clamp(right_px, left, width);
  return sums[static_cast<std::size_t>(right + 0.5F)] - sums[static_cast<std::size_t>(left + 0.5F)];
}

}  // namespace hindsight
