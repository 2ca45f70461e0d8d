// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_rise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace hindsight {
namespace {

/// Rows in which it is looked for, and places in each.
constexpr int kRows = 64, kColumns = 180;
/// The narrowest half width that is tried [px], and how much wider the next ones are; narrower, a road has
/// vanished.
constexpr float kNarrowest = 3.0F, kWidthStep = 1.25F;
/// It begins with the widest of them that is no wider than the road at the hinge, up to this factor.
constexpr float kAsWide = 1.1F;
/// How far above the horizon of flat ground it is looked for, in parts of the way from there to the bottom.
constexpr float kUppermost = 0.25F;
/// For a bend by half the road's width from row to row; for a step narrower, and wider.
constexpr float kBend = 0.5F, kNarrower = 0.1F, kWider = 1.5F;
/// From one row to the next it moves aside by at most this part of its half width: what does not touch it is
/// another.
constexpr float kReach = 1.0F;
/// The road ends where rows fit worse than this.
constexpr float kSeenFit = 0.2F;
/// So much better must it be seen than on flat ground, in rows that fit by 1.
constexpr float kBetter = 3.0F;

using Widths = std::array<float, RoadRise::kWidths>;

Widths half_widths() {
  Widths widths{};
  for (std::size_t j = 0; j < widths.size(); ++j)
    widths[j] = kNarrowest * std::pow(kWidthStep, static_cast<float>(j));
  return widths;
}

const auto kHalf_px = half_widths();

float fit_of(const RoadProfile& profile, int row, float middle_px, float half_px) {
  return judge_road(profile, row, middle_px, half_px, half_px).fit - kSeenFit;
}

}  // namespace

RoadRise::RoadRise(int width_px)
    : step_px_(std::max(1, width_px / kColumns)),
      columns_((width_px + step_px_ - 1) / step_px_),
      profile_(kRows, width_px),
      row_(kRows),
      told_row_(kMostTold),
      road_(kRows),
      told_road_(kMostTold) {
  const std::size_t states = static_cast<std::size_t>(columns_) * kWidths;
  best_.resize(states);
  before_.resize(states);
  from_.resize(states);
  link_.resize(states * kRows);
}

bool RoadRise::find(const RoadHinge& hinge, const RoadColors& colors, const ColorView& picture,
                    std::size_t most_told) {
  told_ = 0;
  lay_rows(hinge, colors, picture);
  if (search(hinge.road.front()) < flat_worth(hinge) + kBetter) return false;
  trace();
  tell(std::min(most_told, kMostTold));
  return told_ > 0;
}

void RoadRise::lay_rows(const RoadHinge& hinge, const RoadColors& colors, const ColorView& picture) {
  const float bottom = static_cast<float>(picture.height_px - 1), from = hinge.row.front().row;
  const float top = std::max(0.0F, hinge.horizon - kUppermost * (bottom - hinge.horizon));
  const float spacing = (from - top) / static_cast<float>(kRows - 1);
  for (int k = 0; k < kRows; ++k) {
    SearchRow& row = row_[static_cast<std::size_t>(k)];
    row.row = from - spacing * static_cast<float>(k);
    row.top = std::clamp(static_cast<int>(std::lround(row.row - 0.5F * spacing)), 0, picture.height_px - 1);
    row.bottom =
        std::clamp(static_cast<int>(std::lround(row.row + 0.5F * spacing)), row.top + 1, picture.height_px);
    profile_.fill(k, colors, picture, row.top, row.bottom);
  }
}

/// What the road on flat ground is worth in the same rows, as far as it is seen.
float RoadRise::flat_worth(const RoadHinge& hinge) const {
  float sum = 0.0F, best = 0.0F;
  std::size_t far = 0;
  for (int k = 0; k < kRows; ++k) {
    const float row = row_[static_cast<std::size_t>(k)].row;
    while (far + 1 < hinge.row.size() && hinge.row[far + 1].row > row) ++far;
    if (far + 1 >= hinge.row.size()) break;
    const float share = (hinge.row[far].row - row) / (hinge.row[far].row - hinge.row[far + 1].row);
    const FoundRoad &a = hinge.road[far], &b = hinge.road[far + 1];
    sum += fit_of(profile_, k, a.middle_px + share * (b.middle_px - a.middle_px),
                  a.half_width_px + share * (b.half_width_px - a.half_width_px));
    best = std::max(best, sum);
  }
  return best;
}

/// Returns what the best path from the start on is worth, up to where it is worth most.
float RoadRise::search(const FoundRoad& start) {
  constexpr float kNever = -1e9F;
  std::fill(best_.begin(), best_.end(), kNever);
  const int column = std::clamp(static_cast<int>(start.middle_px) / step_px_, 0, columns_ - 1);
  const auto wider = std::upper_bound(kHalf_px.begin() + 1, kHalf_px.end(), start.half_width_px * kAsWide);
  best_[state(column, static_cast<std::size_t>(wider - kHalf_px.begin()) - 1)] = 0.0F;
  float most = 0.0F;
  end_row_ = 0;
  for (int row = 0; row < kRows; ++row) {
    step_from(row);
    score(row);
    const auto end = std::max_element(best_.begin(), best_.end());
    if (*end <= most) continue;
    most = *end;
    end_row_ = row;
    end_state_ = static_cast<std::size_t>(end - best_.begin());
  }
  return most;
}

void RoadRise::step_from(int row) {
  before_ = best_;
  step_aside();
  std::swap(best_, before_);
  std::uint16_t* link = &link_[static_cast<std::size_t>(row) * best_.size()];
  for (std::size_t i = 0; i < best_.size(); ++i) {
    const std::size_t width = i % kWidths;
    best_[i] = before_[i], link[i] = from_[i];
    if (width + 1 < kWidths && before_[i + 1] - kNarrower > best_[i])
      best_[i] = before_[i + 1] - kNarrower, link[i] = from_[i + 1];
    if (width > 0 && before_[i - 1] - kWider > best_[i])
      best_[i] = before_[i - 1] - kWider, link[i] = from_[i - 1];
  }
}

/// The cost of a bend is linear in how far it goes, so that two sweeps find the best place to come from.
void RoadRise::step_aside() {
  Widths cost{};
  std::array<std::size_t, kWidths> reach{};
  for (std::size_t j = 0; j < kWidths; ++j) {
    cost[j] = kBend * static_cast<float>(step_px_) / kHalf_px[j];
    reach[j] = static_cast<std::size_t>(static_cast<int>(kReach * kHalf_px[j]) / step_px_) * kWidths;
  }
  std::iota(from_.begin(), from_.end(), std::uint16_t{0});
  const auto come = [&](std::size_t to, std::size_t from) {
    for (std::size_t j = 0; j < kWidths; ++j) {
      const float value = best_[from + j] - cost[j];
      const bool better = value > best_[to + j];
      best_[to + j] = better ? value : best_[to + j];
      from_[to + j] = better ? from_[from + j] : from_[to + j];
    }
  };
  for (std::size_t i = kWidths; i < best_.size(); i += kWidths) come(i, i - kWidths);
  for (std::size_t i = best_.size() - kWidths; i > 0; i -= kWidths) come(i - kWidths, i);
  for (std::size_t i = 0; i < best_.size(); ++i) {
    const std::size_t from = from_[i];
    if (std::max(from, i) - std::min(from, i) <= reach[i % kWidths]) continue;
    best_[i] = before_[i], from_[i] = static_cast<std::uint16_t>(i);
  }
}

/// As fit_of() has it, with edges on whole pixels: what is inside counts twice where all within twice the
/// width is taken off.
void RoadRise::score(int row) {
  const std::span<const float> sums = profile_.sums(row);
  const int width_px = profile_.width_px();
  for (std::size_t j = 0; j < kWidths; ++j) {
    const int half = static_cast<int>(kHalf_px[j] + 0.5F);
    const float share = 0.5F / kHalf_px[j];
    const auto up_to = [&](int column) {
      return sums[static_cast<std::size_t>(std::clamp(column, 0, width_px))];
    };
    for (int column = 0; column < columns_; ++column) {
      const int x = column * step_px_;
      const float inside = up_to(x + half) - up_to(x - half);
      const float around = up_to(x + 2 * half) - up_to(x - 2 * half);
      best_[state(column, j)] += share * (2.0F * inside - around) - kSeenFit;
    }
  }
}

void RoadRise::trace() {
  std::size_t at = end_state_;
  for (int row = end_row_; row >= 0; --row) {
    const std::size_t width = at % kWidths, column = at / kWidths;
    const FoundRoad found{static_cast<float>(column) * static_cast<float>(step_px_), kHalf_px[width], 0.0F,
                          0.0F};
    road_[static_cast<std::size_t>(row)] = refine_road(profile_, row, found, kHalf_px[width]);
    at = link_[static_cast<std::size_t>(row) * best_.size() + at];
  }
}

/// Some of the rows, evenly apart, the last one among them.
void RoadRise::tell(std::size_t most) {
  const auto last = static_cast<std::size_t>(end_row_);
  told_ = std::min(most, last);
  for (std::size_t i = 0; i < told_; ++i) {
    const std::size_t k = (i + 1) * last / told_;
    told_row_[i] = row_[k];
    told_road_[i] = road_[k];
  }
}

}  // namespace hindsight
