// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_color_learner.h"

#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

/// Pixels that a frame's strip, a traced strip, and what lies beside one row count as, so that near and far
/// count alike.
constexpr float kDefinitionCount = 400.0F, kTracedCount = 800.0F, kBesideCount = 60.0F;
/// And the band above the horizon, in parts of the way from there to the bottom.
constexpr float kAboveCount = 100.0F, kAboveFrom = 0.15F, kAboveTo = 0.05F;
/// A traced strip is believed where it became narrower as perspective wants, up to this factor.
constexpr float kMostOff = 1.4F;

}  // namespace

RoadColorLearner::RoadColorLearner(const RoadParams& params, const RoadPicture& picture, int history_depth)
    : params_(params),
      picture_(picture),
      width_(picture.width_px / picture.shrink),
      height_(picture.height_px / picture.shrink),
      definition_(params, picture, history_depth) {}

void RoadColorLearner::fade(double dt_s) {
  colors_.fade(static_cast<float>(std::exp(-dt_s / params_.color_memory_s)));
}

void RoadColorLearner::learn_definition(const RoadInput& input, const ColorView& picture, float horizon,
                                        bool trace) {
  const float shrink = static_cast<float>(picture_.shrink);
  const float height = static_cast<float>(params_.definition_height_px) / shrink;
  const auto add = [&](const ColorView& from, const RoadStrip& strip, float count) {
    const int left = static_cast<int>(strip.left_px / shrink),
              right = static_cast<int>(strip.right_px / shrink);
    const int top = static_cast<int>(strip.top_px / shrink),
              bottom = static_cast<int>(strip.top_px / shrink + height);
    const int area = std::max(1, (right - left) * (bottom - top));
    colors_.add(RoadColors::Side::road, from, left, right, top, bottom, count / static_cast<float>(area));
  };
  const RoadStrip& region = definition_.region();
  add(picture, region, kDefinitionCount);
  if (!trace) return;
  const float horizon_px = picture_.full_px(horizon), half_height_px = 0.5F * height * shrink;
  const float region_slope = region.width_px() / (region.top_px + half_height_px - horizon_px);
  for (const RoadStrip& strip : definition_.trace(input.history, params_.templates)) {
    const float below_px = strip.top_px + half_height_px - horizon_px;
    const float off = strip.width_px() / std::max(1.0F, region_slope * below_px);
    if (below_px <= 0.0F || off > kMostOff || off < 1.0F / kMostOff) continue;
    if (strip.frames_back >= input.appearance.size()) continue;
    add({input.appearance.picture(strip.frames_back), width_, height_}, strip, kTracedCount);
  }
}

void RoadColorLearner::learn_beside(const ColorView& picture, std::span<const SearchRow> rows,
                                    std::span<const FoundRoad> found) {
  for (std::size_t k = 0; k < found.size(); ++k) {
    const FoundRoad& road = found[k];
    if (road.fit < kRoadFits) continue;
    const float half = road.half_width_px;
    const SearchRow& row = rows[k];
    const auto add = [&](float from, float to) {
      const int left = std::max(0, static_cast<int>(from)), right = std::min(width_, static_cast<int>(to));
      const int area = (right - left) * (row.bottom - row.top);
      if (right - left < 2) return;
      colors_.add(RoadColors::Side::beside, picture, left, right, row.top, row.bottom,
                  kBesideCount / static_cast<float>(area));
    };
    add(road.middle_px - 2.2F * half, road.middle_px - 1.2F * half);
    add(road.middle_px + 1.2F * half, road.middle_px + 2.2F * half);
  }
}

void RoadColorLearner::learn_above(const ColorView& picture, float horizon) {
  const float deepest = static_cast<float>(height_ - 1) - horizon;
  const int top = std::max(0, static_cast<int>(horizon - kAboveFrom * deepest));
  const int bottom = static_cast<int>(horizon - kAboveTo * deepest);
  if (bottom <= top) return;
  colors_.add(RoadColors::Side::beside, picture, 0, width_, top, bottom,
              kAboveCount / static_cast<float>(width_ * (bottom - top)));
}

void RoadColorLearner::learn_beside_anything(const ColorView& picture, std::span<const SearchRow> rows,
                                             float horizon) {
  const float middle = 0.5F * static_cast<float>(width_);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const float half = std::max(0.2F * middle, kWidestRoadSlope * (rows[k].row - horizon));
    if (half > 0.8F * middle) continue;
    const int left = static_cast<int>(middle - half), right = static_cast<int>(middle + half);
    const int area = 2 * left * (rows[k].bottom - rows[k].top);
    const float weight = 2.0F * kBesideCount / static_cast<float>(std::max(1, area));
    colors_.add(RoadColors::Side::beside, picture, 0, left, rows[k].top, rows[k].bottom, weight);
    colors_.add(RoadColors::Side::beside, picture, right, width_, rows[k].top, rows[k].bottom, weight);
  }
}

}  // namespace hindsight
