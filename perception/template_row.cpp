// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/template_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "config/exit_code.h"
#include "perception/multiversion.h"
#include "perception/quad_correlation.h"

namespace hindsight {
namespace {

constexpr int kChannels = 3;
/// Taken from the strip's values, so that they fit into a byte with a sign, and given back to the sums.
constexpr int kMiddleValue = 128;

std::size_t rounded_up(int value, std::size_t multiple) {
  return (static_cast<std::size_t>(value) + multiple - 1) / multiple * multiple;
}

/// The three channels of a row of `count` pixels as quads from each pixel on, each channel to its own plane;
/// zeros beyond the row.
HINDSIGHT_MULTIVERSION void spread(const std::uint8_t* bgr, int count, std::uint32_t* blue,
                                   std::uint32_t* green, std::uint32_t* red) {
  const int whole = std::max(0, count - 3);
  for (int x = 0; x < whole; ++x) {
    const std::uint8_t* p = bgr + kChannels * x;
    blue[x] = quad_of(p, kChannels);
    green[x] = quad_of(p + 1, kChannels);
    red[x] = quad_of(p + 2, kChannels);
  }
  for (int x = whole; x < count; ++x) {
    std::uint8_t rest[4 * kChannels] = {};
    std::copy(bgr + kChannels * x, bgr + kChannels * count, rest);
    blue[x] = quad_of(rest, kChannels);
    green[x] = quad_of(rest + 1, kChannels);
    red[x] = quad_of(rest + 2, kChannels);
  }
}

/// Adds the row's values, or their squares, to one sum for each pixel.
HINDSIGHT_MULTIVERSION void add_values(const std::uint8_t* bgr, int count, std::uint32_t* sums) {
  for (int x = 0; x < count; ++x, bgr += kChannels)
    sums[x] += static_cast<std::uint32_t>(bgr[0] + bgr[1] + bgr[2]);
}
HINDSIGHT_MULTIVERSION void add_squares(const std::uint8_t* bgr, int count, std::uint32_t* sums) {
  for (int x = 0; x < count; ++x, bgr += kChannels)
    sums[x] += static_cast<std::uint32_t>(bgr[0] * bgr[0] + bgr[1] * bgr[1] + bgr[2] * bgr[2]);
}

}  // namespace

TemplateRow::TemplateRow(int picture_width_px, int max_width_px, int max_height_px)
    : picture_width_px_(picture_width_px),
      max_height_px_(max_height_px),
      plane_stride_(rounded_up(picture_width_px, kPlacesAtOnce) + rounded_up(max_width_px, 4) +
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
  template_quads_.resize(planes * (rounded_up(max_width_px, 4) / 4));
  picture_quads_.resize(planes * plane_stride_);
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
  auto quad = template_quads_.begin();
  for (int row = 0; row < height_px; ++row) {
    const std::uint8_t* from = picture.pixel(left_px, top_px + row);
    for (int k = 0; k < kChannels * width_px; ++k) {
      template_sum_ += from[k];
      template_energy_ += from[k] * from[k];
    }
    for (int channel = 0; channel < kChannels; ++channel) {
      for (int x = 0; x < width_px; x += 4) {
        std::uint32_t word = 0;
        for (int k = std::min(4, width_px - x); k-- > 0;)
          word = word << 8 | static_cast<std::uint8_t>(from[kChannels * (x + k) + channel] - kMiddleValue);
        *quad++ = word;
      }
    }
  }
}

std::span<const float> TemplateRow::search(const ColorView& picture, int top_px, TemplateMatch match) {
  const int places = picture.width_px - width_px_ + 1;
  spread_rows(picture, top_px);
  sum_energy(picture, top_px);
  const auto middle = static_cast<std::uint32_t>(kMiddleValue);
  std::transform(sums_.begin(), sums_.end(), products_.begin(),
                 [middle](std::int64_t sum) { return middle * static_cast<std::uint32_t>(sum); });
  const std::size_t quads = rounded_up(width_px_, 4) / 4;
  const auto planes = static_cast<std::size_t>(kChannels * height_px_);
  AddQuadProducts* const kernel = quad_product_kernels().front();
  for (std::size_t plane = 0; plane < planes; ++plane) {
    kernel(&picture_quads_[plane * plane_stride_], &template_quads_[plane * quads], quads,
           rounded_up(places, kPlacesAtOnce), products_.data());
  }
  score(match, places);
  return std::span<const float>(response_).first(static_cast<std::size_t>(places));
}

void TemplateRow::spread_rows(const ColorView& picture, int top_px) {
  for (int row = 0; row < height_px_; ++row) {
    std::uint32_t* planes = &picture_quads_[static_cast<std::size_t>(kChannels * row) * plane_stride_];
    spread(picture.pixel(0, top_px + row), picture.width_px, planes, planes + plane_stride_,
           planes + 2 * plane_stride_);
  }
}

/// Sums over columns up to each, so that those under the strip are a difference.
void TemplateRow::sum_energy(const ColorView& picture, int top_px) {
  const auto width = static_cast<std::size_t>(picture.width_px);
  const auto sum_up = [&](auto&& add, std::vector<std::int64_t>& sums) {
    std::fill(products_.begin(), products_.end(), 0U);  // lends its room
    for (int row = 0; row < height_px_; ++row)
      add(picture.pixel(0, top_px + row), picture.width_px, products_.data());
    for (std::size_t x = 0; x < width; ++x) sums[x + 1] = sums[x] + products_[x];
  };
  sum_up(add_values, column_sums_);
  sum_up(add_squares, column_energies_);
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
      // (4.1); what differs by more than the pictures' own energy is no match, as OpenCV has it, too.
      if (norm > 0.0) value = std::min(1.0, (energy_T - 2.0 * product + energy_I) / norm);
    } else {
      const double norm = std::sqrt(variance_T * (energy_I - sum_I * sum_I / n));
      if (norm > 0.0) value = 1.0 - (product - sum_T * sum_I / n) / norm;
    }
    response_[x] = static_cast<float>(value);
  }
}

}  // namespace hindsight
