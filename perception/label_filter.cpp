// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/label_filter.h"

#include <algorithm>
#include <cmath>

#include "config/exit_code.h"

namespace hindsight {
namespace {

constexpr unsigned kLethalShift = 8;

/// 1 for an obstacle, and 256 more for a lethal one: a window of at most 15 x 15 keeps both counts apart.
constexpr std::uint16_t packed(TerrainClass label) {
  const bool lethal = label == TerrainClass::lethal, bad = label == TerrainClass::bad;
  return static_cast<std::uint16_t>((lethal || bad ? 1U : 0U) + (lethal ? 1U << kLethalShift : 0U));
}

}  // namespace

LabelFilter::LabelFilter(const LabelFilterParams& params, int width_px, int height_px)
    : radius_px_(params.window_px / 2),
      width_px_(width_px),
      height_px_(height_px),
      fewest_(static_cast<std::uint16_t>(
          std::max(1.0, std::ceil(params.share * params.window_px * params.window_px - 1e-9)))),
      columns_(static_cast<std::size_t>(width_px + 2 * radius_px_)),
      sums_(static_cast<std::size_t>(width_px)),
      smoothed_(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px)) {
  if (params.window_px % 2 == 0) throw FatalError(kExitConfiguration, "label_filter.window_px must be odd");
}

std::span<const TerrainClass> LabelFilter::smooth(std::span<const TerrainClass> labels) {
  if (radius_px_ == 0) return labels;
  std::ranges::fill(columns_, std::uint16_t{0});
  for (int row = -radius_px_; row < radius_px_; ++row) add_row(labels, row, false);
  for (int row = 0; row < height_px_; ++row) {
    add_row(labels, row + radius_px_, false);
    sum_across();
    const std::size_t begin = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_px_);
    decide(&labels[begin], &smoothed_[begin]);
    add_row(labels, row - radius_px_, true);
  }
  return smoothed_;
}

void LabelFilter::add_row(std::span<const TerrainClass> labels, int row, bool remove) {
  const auto width = static_cast<std::size_t>(width_px_), radius = static_cast<std::size_t>(radius_px_);
  const TerrainClass* line = &labels[static_cast<std::size_t>(std::clamp(row, 0, height_px_ - 1)) * width];
  const auto sign = static_cast<std::uint16_t>(remove ? -1 : 1);
  std::uint16_t* columns = &columns_[radius];
  for (std::size_t x = 0; x < width; ++x)
    columns[x] = static_cast<std::uint16_t>(columns[x] + sign * packed(line[x]));
  std::fill_n(columns_.begin(), radius, columns[0]);
  std::fill_n(columns + width, radius, columns[width - 1]);
}

void LabelFilter::sum_across() {
  std::ranges::fill(sums_, std::uint16_t{0});
  for (std::size_t k = 0; k <= 2 * static_cast<std::size_t>(radius_px_); ++k) {
    const std::uint16_t* columns = &columns_[k];
    for (std::size_t x = 0; x < sums_.size(); ++x)
      sums_[x] = static_cast<std::uint16_t>(sums_[x] + columns[x]);
  }
}

void LabelFilter::decide(const TerrainClass* labels, TerrainClass* out) const {
  constexpr std::uint16_t kObstacles = (1U << kLethalShift) - 1U;
  for (std::size_t x = 0; x < sums_.size(); ++x) {
    const auto obstacles = static_cast<std::uint16_t>(sums_[x] & kObstacles);
    const auto lethal = static_cast<std::uint16_t>(sums_[x] >> kLethalShift);
    const TerrainClass hazard = 2 * lethal >= obstacles ? TerrainClass::lethal : TerrainClass::bad;
    const TerrainClass alone = packed(labels[x]) != 0 ? TerrainClass::unknown : labels[x];
    out[x] = obstacles >= fewest_ ? hazard : alone;
  }
}

}  // namespace hindsight
