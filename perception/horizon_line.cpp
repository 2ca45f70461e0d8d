// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/horizon_line.h"

#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

/// The picture is looked at in columns of blocks, about so many.
constexpr int kColumns = 60;
constexpr float kSteepest = 0.35F;
constexpr int kHeights = 20, kAngles = 9;
constexpr int kRefinements = 4;

double variance(double n, double sum, double squares) {
  if (n <= 0.0) return 0.0;
  const double mean = sum / n;
  return std::max(0.0, squares / n - mean * mean);
}

}  // namespace

HorizonFinder::HorizonFinder(int width_px, int height_px)
    : step_(std::max(1, width_px / kColumns)), columns_(width_px / step_), rows_(height_px / step_) {
  const auto size = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_ + 1);
  sums_.resize(size);
  squares_.resize(size);
}

/// One pixel of each block: the horizon needs no more.
void HorizonFinder::shrink(const ColorView& picture) {
  for (int column = 0; column < columns_; ++column) {
    std::size_t i = static_cast<std::size_t>(column) * static_cast<std::size_t>(rows_ + 1);
    sums_[i] = squares_[i] = 0.0;
    for (int row = 0; row < rows_; ++row, ++i) {
      const double blue = picture.pixel(column * step_ + step_ / 2, row * step_ + step_ / 2)[0];
      sums_[i + 1] = sums_[i] + blue;
      squares_[i + 1] = squares_[i] + blue * blue;
    }
  }
}

HorizonFinder::Moments HorizonFinder::above(int column, float row) const {
  const int rows = std::clamp(static_cast<int>(std::lround(row)), 0, rows_);
  const auto i =
      static_cast<std::size_t>(column) * static_cast<std::size_t>(rows_ + 1) + static_cast<std::size_t>(rows);
  return {static_cast<double>(rows), sums_[i], squares_[i]};
}

double HorizonFinder::spread_of(float middle_row, float tan_angle) const {
  Moments sky, ground;
  for (int column = 0; column < columns_; ++column) {
    const float from_middle = static_cast<float>(column) - 0.5F * static_cast<float>(columns_ - 1);
    const Moments a = above(column, middle_row + tan_angle * from_middle);
    const Moments all = above(column, static_cast<float>(rows_));
    sky.n += a.n, sky.sum += a.sum, sky.squares += a.squares;
    ground.n += all.n - a.n, ground.sum += all.sum - a.sum, ground.squares += all.squares - a.squares;
  }
  return variance(sky.n, sky.sum, sky.squares) + variance(ground.n, ground.sum, ground.squares);
}

HorizonLine HorizonFinder::find(const ColorView& picture) {
  shrink(picture);
  float best_row = 0.0F, best_angle = 0.0F;
  double best = spread_of(0.0F, 0.0F);
  const double whole = best;
  float row_reach = 0.5F * static_cast<float>(rows_), angle_reach = kSteepest;
  float around_row = row_reach, around_angle = 0.0F;
  for (int round = 0; round <= kRefinements; ++round) {
    for (int i = -kHeights; i <= kHeights; ++i) {
      for (int j = -kAngles; j <= kAngles; ++j) {
        const float row = around_row + row_reach * static_cast<float>(i) / kHeights;
        const float angle = around_angle + angle_reach * static_cast<float>(j) / kAngles;
        const double spread = spread_of(row, angle);
        if (spread >= best) continue;
        best = spread, best_row = row, best_angle = angle;
      }
    }
    around_row = best_row, around_angle = best_angle;
    row_reach *= 0.25F, angle_reach *= 0.25F;
  }
  const auto step = static_cast<float>(step_);
  return {best_row * step, best_angle, whole > 0.0 ? static_cast<float>(1.0 - best / whole) : 0.0F};
}

}  // namespace hindsight
