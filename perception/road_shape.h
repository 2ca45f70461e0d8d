// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A road on flat ground: its half width grows in proportion to the way down from the horizon.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>

#include "perception/road_color_learner.h"
#include "perception/road_search.h"

namespace hindsight {

/// Rows and columns of a stored picture.
struct RoadShape {
  /// No road is expected to be narrower than this half width, however far away.
  static constexpr float kNarrowest_px = 2.5F;

  float horizon = 0.0F;
  float slope = 1.0F;  ///< half the road's width over the camera's height

  float half_width_px(float row) const { return std::max(kNarrowest_px, slope * (row - horizon)); }
};

/// Lays rows from the bottom of a picture so many pixels high to just above the horizon, evenly spaced; each
/// is the mean of the pixel rows around it.
void lay_road_rows(const RoadShape& shape, int height_px, std::span<SearchRow> rows);

/// A road whose end is not seen goes on as straight as over so many rows.
constexpr std::size_t kStraightRows = 5;
/// Its middle in row k, at least kStraightRows, from what is expected of the rows before.
float straight_on(std::span<const SearchRow> rows, std::span<const ExpectedRoad> expected, std::size_t k);

/// Does the road lie in the picture from edge to edge?
bool is_whole(const FoundRoad& road, int width_px);

/// A straight line through the half widths of the rows that are whole and fit; where it is zero lies the
/// horizon. Empty where these are too few.
std::optional<RoadShape> fit_road_shape(std::span<const SearchRow> rows, std::span<const FoundRoad> roads,
                                        int width_px);

}  // namespace hindsight
