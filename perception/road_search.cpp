// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_search.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hindsight {
namespace {

/// So much of the expected half width on each side is looked at beside the road.
constexpr float kBeside = 1.0F;
/// From one row to the next, the road moves aside by less than this part of its half width, and this many
/// steps.
constexpr float kMostBend = 0.35F;
constexpr int kMostBendSteps = 6;
/// An edge is refined within this part of the half width; the further, the more it must gain.
constexpr float kRefine = 0.15F, kRefineCost = 0.5F;

std::array<float, 2 * RoadSearch::kWidthSteps + 1> width_factors() {
  std::array<float, 2 * RoadSearch::kWidthSteps + 1> factors{};
  for (int i = 0; i < static_cast<int>(factors.size()); ++i)
    factors[static_cast<std::size_t>(i)] =
        std::pow(RoadSearch::kWidthStep, static_cast<float>(i - RoadSearch::kWidthSteps));
  return factors;
}

const auto kFactors = width_factors();

}  // namespace

FoundRoad judge_road(const RoadProfile& profile, int row, float middle_px, float half_width_px,
                     float expected_half_width_px) {
  const float left = middle_px - half_width_px, right = middle_px + half_width_px;
  const float beside_px = kBeside * expected_half_width_px;
  const float inside = profile.between(row, left, right);
  const float beside =
      profile.between(row, left - beside_px, left) + profile.between(row, right, right + beside_px);
  return {middle_px, half_width_px, (inside - beside) / (2.0F * expected_half_width_px),
          inside / (2.0F * half_width_px) - beside / (2.0F * beside_px)};
}

FoundRoad refine_road(const RoadProfile& profile, int row, const FoundRoad& road,
                      float expected_half_width_px) {
  const float left = road.middle_px - road.half_width_px, right = road.middle_px + road.half_width_px;
  const float reach = std::floor(kRefine * road.half_width_px);
  float best_left = left, best_right = right, most_left = 0.0F, most_right = 0.0F;
  for (float by = -reach; by <= reach; by += 1.0F) {
    // What the road gains if its edge moves outwards by so much.
    const float pull = kRefineCost * by * by / road.half_width_px;
    const float gain_left =
        by > 0.0F ? profile.between(row, left - by, left) : -profile.between(row, left, left - by);
    const float gain_right =
        by > 0.0F ? profile.between(row, right, right + by) : -profile.between(row, right + by, right);
    if (left > 0.0F && gain_left - pull > most_left) most_left = gain_left - pull, best_left = left - by;
    if (right < static_cast<float>(profile.width_px()) && gain_right - pull > most_right)
      most_right = gain_right - pull, best_right = right + by;
  }
  return judge_road(profile, row, 0.5F * (best_left + best_right), 0.5F * (best_right - best_left),
                    expected_half_width_px);
}

RoadSearch::RoadSearch(int rows, int step_px, int most_steps)
    : step_px_(static_cast<float>(step_px)),
      states_(static_cast<std::size_t>((2 * most_steps + 1) * kWidths)) {
  fit_.resize(states_);
  best_.resize(states_);
  best_before_.resize(states_);
  link_.resize(static_cast<std::size_t>(rows) * states_);
  found_.resize(static_cast<std::size_t>(rows));
}

std::span<const FoundRoad> RoadSearch::find(const RoadProfile& profile,
                                            std::span<const ExpectedRoad> expected, int steps,
                                            const RoadSearchCosts& costs) {
  for (int row = 0; row < static_cast<int>(expected.size()); ++row) {
    const ExpectedRoad& here = expected[static_cast<std::size_t>(row)];
    score_row(profile, row, here, steps, costs);
    if (row == 0) {
      best_ = fit_;
    } else {
      step_from(row, here, steps, costs);
    }
  }
  trace(profile, expected, steps);
  return std::span<const FoundRoad>(found_).first(expected.size());
}

void RoadSearch::score_row(const RoadProfile& profile, int row, const ExpectedRoad& expected, int steps,
                           const RoadSearchCosts& costs) {
  for (int i = 0; i <= 2 * steps; ++i) {
    const float offset_px = step_px_ * static_cast<float>(i - steps);
    const float stray = offset_px / expected.half_width_px;
    for (int j = 0; j < kWidths; ++j) {
      const float half_px = kFactors[static_cast<std::size_t>(j)] * expected.half_width_px;
      const auto steps_off = static_cast<float>(j - kWidthSteps);
      fit_[state(i, j)] =
          judge_road(profile, row, expected.middle_px + offset_px, half_px, expected.half_width_px).fit -
          costs.stray * stray * stray - costs.odd_width * steps_off * steps_off;
    }
  }
}

void RoadSearch::step_from(int row, const ExpectedRoad& expected, int steps, const RoadSearchCosts& costs) {
  std::swap(best_, best_before_);
  std::uint16_t* link = &link_[static_cast<std::size_t>(row) * states_];
  const int reach =
      std::clamp(static_cast<int>(kMostBend * expected.half_width_px / step_px_), 1, kMostBendSteps);
  const float bend = costs.bend * step_px_ * step_px_ / (expected.half_width_px * expected.half_width_px);
  for (int i = 0; i <= 2 * steps; ++i) {
    for (int j = 0; j < kWidths; ++j) {
      float best = -1e9F;
      for (int from = std::max(i - reach, 0); from <= std::min(i + reach, 2 * steps); ++from) {
        const float aside = static_cast<float>(i - from);
        for (int width = std::max(j - 1, 0); width <= std::min(j + 1, kWidths - 1); ++width) {
          const float value =
              best_before_[state(from, width)] - bend * aside * aside - (width == j ? 0.0F : costs.widen);
          if (value <= best) continue;
          best = value;
          link[state(i, j)] = static_cast<std::uint16_t>(state(from, width));
        }
      }
      best_[state(i, j)] = best + fit_[state(i, j)];
    }
  }
}

void RoadSearch::trace(const RoadProfile& profile, std::span<const ExpectedRoad> expected, int steps) {
  const auto count = static_cast<std::ptrdiff_t>(state(2 * steps, kWidths - 1)) + 1;
  const auto end = std::max_element(best_.begin(), best_.begin() + count);
  total_ = *end;
  auto at = static_cast<std::size_t>(end - best_.begin());
  for (std::size_t row = expected.size(); row-- > 0;) {
    const float offset_px = step_px_ * static_cast<float>(static_cast<int>(at / kWidths) - steps);
    found_[row] =
        judge_road(profile, static_cast<int>(row), expected[row].middle_px + offset_px,
                   kFactors[at % kWidths] * expected[row].half_width_px, expected[row].half_width_px);
    if (row > 0) at = link_[row * states_ + at];
  }
}

}  // namespace hindsight
