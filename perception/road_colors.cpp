// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_colors.h"

#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

/// Brightness in 16 steps of 16; red against green and blue against both in 32 steps of 4 around grey: shade
/// changes brightness much and hue little.
constexpr int kBrightBins = 16, kHueBins = 32;
constexpr int kBins = kBrightBins * kHueBins * kHueBins;
/// Counts that each bin has beforehand: what was seen less often than this means nothing.
constexpr float kPriorCount = 3.0F;
/// Likelihood ratios beyond e to this are cut off.
constexpr float kMostLog = 2.0F;

int hue_bin(int difference) { return std::clamp((difference + 64) >> 2, 0, kHueBins - 1); }

/// [1 2 1] / 4 along an axis of the histogram; what would leave it stays at its end.
void smooth_along(const std::vector<float>& from, std::vector<float>& to, int step, int length) {
  for (int i = 0; i < kBins; ++i) {
    const int place = i / step % length;
    const float before = from[static_cast<std::size_t>(place > 0 ? i - step : i)];
    const float after = from[static_cast<std::size_t>(place + 1 < length ? i + step : i)];
    to[static_cast<std::size_t>(i)] = 0.25F * (before + 2.0F * from[static_cast<std::size_t>(i)] + after);
  }
}

}  // namespace

RoadColors::RoadColors() {
  for (auto* table : {&road_, &beside_, &smooth_road_, &smooth_beside_, &scratch_, &likelihood_})
    table->assign(kBins, 0.0F);
}

std::size_t RoadColors::bin_of(const std::uint8_t* bgr) {
  const int b = bgr[0], g = bgr[1], r = bgr[2];
  const int bright = (b + 2 * g + r) >> 6;
  return static_cast<std::size_t>((bright * kHueBins + hue_bin(r - g)) * kHueBins + hue_bin(b - (r + g) / 2));
}

void RoadColors::add(Side side, const ColorView& picture, int left_px, int right_px, int top_px,
                     int bottom_px, float weight) {
  std::vector<float>& counts = side == Side::road ? road_ : beside_;
  float& total = side == Side::road ? road_total_ : beside_total_;
  const int right = std::min(right_px, picture.width_px), bottom = std::min(bottom_px, picture.height_px);
  for (int row = std::max(top_px, 0); row < bottom; ++row) {
    for (int column = std::max(left_px, 0); column < right; ++column) {
      counts[bin_of(picture.pixel(column, row))] += weight;
      total += weight;
    }
  }
}

void RoadColors::fade(float factor) {
  for (auto* counts : {&road_, &beside_}) {
    for (float& count : *counts) count *= factor;
  }
  road_total_ *= factor;
  beside_total_ *= factor;
}

void RoadColors::clear() {
  for (auto* table : {&road_, &beside_, &likelihood_}) std::fill(table->begin(), table->end(), 0.0F);
  road_total_ = beside_total_ = 0.0F;
}

void RoadColors::smooth(const std::vector<float>& counts, std::vector<float>& smoothed) {
  smooth_along(counts, smoothed, 1, kHueBins);
  smooth_along(smoothed, scratch_, kHueBins, kHueBins);
  smooth_along(scratch_, smoothed, kHueBins * kHueBins, kBrightBins);
}

void RoadColors::refresh() {
  smooth(road_, smooth_road_);
  smooth(beside_, smooth_beside_);
  // Both sides as if of equally many pixels, so that the share of the picture that is road does not matter.
  const float most = std::max({road_total_, beside_total_, 1.0F});
  const float road_scale = most / std::max(road_total_, 1.0F),
              beside_scale = most / std::max(beside_total_, 1.0F);
  for (std::size_t i = 0; i < likelihood_.size(); ++i) {
    const float ratio =
        (road_scale * smooth_road_[i] + kPriorCount) / (beside_scale * smooth_beside_[i] + kPriorCount);
    likelihood_[i] = std::clamp(std::log(ratio), -kMostLog, kMostLog) / kMostLog;
  }
}

}  // namespace hindsight
