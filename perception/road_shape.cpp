// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_shape.h"

namespace hindsight {
namespace {

/// The farthest row, in parts of the way from the horizon to the bottom; above the horizon, as ground may
/// rise.
constexpr float kFarthest = -0.04F;
constexpr float kFewestRows = 5.0F;

}  // namespace

void lay_road_rows(const RoadShape& shape, int height_px, std::span<SearchRow> rows) {
  const float bottom = static_cast<float>(height_px - 1);
  const float deepest = bottom - shape.horizon;
  const float spacing = deepest * (1.0F - kFarthest) / static_cast<float>(rows.size() - 1);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    SearchRow& row = rows[k];
    row.row = bottom - spacing * static_cast<float>(k);
    const float reach = 0.5F * std::min(spacing, 0.15F * std::max(0.0F, row.row - shape.horizon));
    row.top = std::clamp(static_cast<int>(row.row - reach), 0, height_px - 1);
    row.bottom = std::clamp(static_cast<int>(row.row + reach) + 1, row.top + 1, height_px);
  }
}

float straight_on(std::span<const SearchRow> rows, std::span<const ExpectedRoad> expected, std::size_t k) {
  const std::size_t last = k - 1, first = k - kStraightRows;
  const float per_row =
      (expected[last].middle_px - expected[first].middle_px) / (rows[last].row - rows[first].row);
  return expected[last].middle_px + per_row * (rows[k].row - rows[last].row);
}

bool is_whole(const FoundRoad& road, int width_px) {
  return road.middle_px - road.half_width_px > 0.0F &&
         road.middle_px + road.half_width_px < static_cast<float>(width_px);
}

std::optional<RoadShape> fit_road_shape(std::span<const SearchRow> rows, std::span<const FoundRoad> roads,
                                        int width_px) {
  float n = 0.0F, y = 0.0F, w = 0.0F, yy = 0.0F, yw = 0.0F;
  for (std::size_t k = 0; k < roads.size(); ++k) {
    if (!is_whole(roads[k], width_px) || roads[k].fit < kRoadFits) continue;
    const float half = roads[k].half_width_px, row = rows[k].row;
    n += 1.0F, y += row, w += half, yy += row * row, yw += row * half;
  }
  const float spread = n * yy - y * y;
  if (n < kFewestRows || spread <= 0.0F) return std::nullopt;
  const float slope = (n * yw - y * w) / spread;
  return RoadShape{(y - w / slope) / n, slope};
}

}  // namespace hindsight
