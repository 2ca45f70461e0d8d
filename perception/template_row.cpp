// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/template_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/exit_code.h"
#include "perception/pair_correlation.h"

namespace hindsight {
namespace {

constexpr int kChannels = 3;

std::size_t rounded_up(int value, std::size_t multiple) {
  return (static_cast<std::size_t>(value) + multiple - 1) / multiple * multiple;
}

/// Values of one channel of a row as pairs from each pixel on; beyond `count` there are zeros.
void spread(const std::uint8_t* bgr, int channel, int count, std::int32_t* pairs) {
  const std::uint8_t* from = bgr + channel;
  for (int x = 0; x + 1 < count; ++x) pairs[x] = pair_of(from[kChannels * x], from[kChannels * (x + 1)]);
  pairs[count - 1] = from[kChannels * (count - 1)];
}

}  // namespace

TemplateRow::TemplateRow(int picture_width_px, int max_width_px, int max_height_px)
    : picture_width_px_(picture_width_px),
      max_height_px_(max_height_px),
      plane_stride_(rounded_up(picture_width_px, kPlacesAtOnce) + rounded_up(max_width_px, 2) +
                    kPlacesAtOnce) {
  const std::int64_t largest = 255LL * 255 * kChannels * max_width_px * max_height_px;
  if (largest > std::numeric_limits<std::uint32_t>::max()) {
    throw FatalError(
        kExitConfiguration,
        fmt::format("road: a strip of {} x {} px is too large to be matched; expected at most {} pixels",
                    max_width_px, max_height_px,
                    std::numeric_limits<std::uint32_t>::max() / (255 * 255 * kChannels)));
  }
  const auto planes = static_cast<std::size_t>(kChannels * max_height_px);
  const auto width = static_cast<std::size_t>(picture_width_px);
  template_pairs_.resize(planes * (rounded_up(max_width_px, 2) / 2));
  picture_pairs_.resize(planes * plane_stride_);
  products_.resize(rounded_up(picture_width_px, kPlacesAtOnce));
  column_sums_.resize(width + 1);
  column_energies_.resize(width + 1);
  sums_.resize(width);
  energies_.resize(width);
  response_.resize(width);
}

void TemplateRow::take(const ColorView& picture, int left_px, int top_px, int width_px, int height_px) {
  width_px_ = width_px;
  height_px_ = height_px;
  template_sum_ = template_energy_ = 0;
  auto pair = template_pairs_.begin();
  for (int row = 0; row < height_px; ++row) {
    const std::uint8_t* from = picture.pixel(left_px, top_px + row);
    for (int k = 0; k < kChannels * width_px; ++k) {
      template_sum_ += from[k];
      template_energy_ += from[k] * from[k];
    }
    for (int channel = 0; channel < kChannels; ++channel) {
      for (int x = 0; x < width_px; x += 2) {
        const std::int32_t right = x + 1 < width_px ? from[kChannels * (x + 1) + channel] : 0;
        *pair++ = pair_of(from[kChannels * x + channel], right);
      }
    }
  }
}

std::span<const float> TemplateRow::search(const ColorView& picture, int top_px, TemplateMatch match) {
  const int places = picture.width_px - width_px_ + 1;
  spread_rows(picture, top_px);
  sum_energy(picture, top_px);
  std::fill(products_.begin(), products_.end(), 0U);
  const std::size_t pairs = rounded_up(width_px_, 2) / 2;
  const auto planes = static_cast<std::size_t>(kChannels * height_px_);
  for (std::size_t plane = 0; plane < planes; ++plane) {
    add_pair_products(&picture_pairs_[plane * plane_stride_], &template_pairs_[plane * pairs], pairs,
                      rounded_up(places, kPlacesAtOnce), products_.data());
  }
  score(match, places);
  return std::span<const float>(response_).first(static_cast<std::size_t>(places));
}

void TemplateRow::spread_rows(const ColorView& picture, int top_px) {
  for (int row = 0; row < height_px_; ++row) {
    const std::uint8_t* from = picture.pixel(0, top_px + row);
    for (int channel = 0; channel < kChannels; ++channel) {
      const auto plane = static_cast<std::size_t>(kChannels * row + channel);
      spread(from, channel, picture.width_px, &picture_pairs_[plane * plane_stride_]);
    }
  }
}

/// Sums over columns up to each, so that those under the strip are a difference.
void TemplateRow::sum_energy(const ColorView& picture, int top_px) {
  const auto width = static_cast<std::size_t>(picture.width_px);
  std::fill(column_sums_.begin(), column_sums_.end(), 0);
  std::fill(column_energies_.begin(), column_energies_.end(), 0);
  for (int row = 0; row < height_px_; ++row) {
    const std::uint8_t* from = picture.pixel(0, top_px + row);
    for (std::size_t x = 0; x < width; ++x, from += kChannels) {
      column_sums_[x + 1] += from[0] + from[1] + from[2];
      column_energies_[x + 1] += from[0] * from[0] + from[1] * from[1] + from[2] * from[2];
    }
  }
  for (std::size_t x = 0; x < width; ++x) {
    column_sums_[x + 1] += column_sums_[x];
    column_energies_[x + 1] += column_energies_[x];
  }
  const auto strip = static_cast<std::size_t>(width_px_);
  for (std::size_t x = 0; x + strip <= width; ++x) {
    sums_[x] = column_sums_[x + strip] - column_sums_[x];
    energies_[x] = column_energies_[x + strip] - column_energies_[x];
  }
}

void TemplateRow::score(TemplateMatch match, int places) {
  const auto n = static_cast<double>(kChannels * width_px_ * height_px_);
  const auto sum_T = static_cast<double>(template_sum_), energy_T = static_cast<double>(template_energy_);
  const double variance_T = energy_T - sum_T * sum_T / n;
  for (std::size_t x = 0; x < static_cast<std::size_t>(places); ++x) {
    const auto sum_I = static_cast<double>(sums_[x]), energy_I = static_cast<double>(energies_[x]);
    const auto product = static_cast<double>(products_[x]);
    double value = 1.0;
    if (match == TemplateMatch::squared_difference) {
      const double norm = std::sqrt(energy_T * energy_I);
      if (norm > 0.0) value = (energy_T - 2.0 * product + energy_I) / norm;  // (4.1)
    } else {
      const double norm = std::sqrt(variance_T * (energy_I - sum_I * sum_I / n));
      if (norm > 0.0) value = 1.0 - (product - sum_T * sum_I / n) / norm;
    }
    response_[x] = static_cast<float>(value);
  }
}

}  // namespace hindsight
