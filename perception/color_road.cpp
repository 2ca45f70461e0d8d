// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/color_road.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hindsight {
namespace {

/// Half widths per row below the horizon (half the road's width over the camera's height) that are tried
/// where no road is known, and horizons in parts of the picture's height where the camera does not tell.
constexpr std::array kSlopes{0.5F, 0.8F, 1.25F, 2.0F, kWidestRoadSlope};
constexpr std::array kHorizons{0.2F, 0.3F, 0.4F, 0.5F};
/// Standard deviations of a row's middle in half widths, where the fit is 1.
constexpr float kRowSigma = 0.15F;
/// Rows that fit worse than this are no more uncertain.
constexpr float kLeastFit = 0.05F;
/// For each step of width away from what is expected, squared: the mouths of side roads are not the road.
constexpr float kOddWidthCost = 0.07F;
/// How fast slope and horizon follow what the rows' widths say; a calibrated horizon, more slowly.
constexpr double kShapeMemory_s = 2.0;
constexpr float kAcquireGain = 0.5F, kCalibratedPart = 0.2F;
/// Far things' motion tells how the vehicle pitches, but summed up for longer it would run away.
constexpr double kSwingMemory_s = 1.0;
/// What the widths say of the horizon is not believed if it is so far off, in parts of the way down to the
/// bottom.
constexpr float kMostOffHorizon = 0.25F;
constexpr int kAcquireRounds = 4;
/// A road is looked for anew so often: it takes ten times as long as following one.
constexpr double kAcquireEvery_s = 0.5;
/// Where nothing else ends the road, it ends where rows fit worse than this.
constexpr float kVisibleFit = 0.65F;
/// Or, where little stands out anyway, than this part of how the near half of the rows does.
constexpr float kVisibleShare = 0.4F;
/// Whose mean likelihood is less than this is no road, however it stands out.
constexpr float kUnlike = -0.2F;
/// Offsets tried, in profile columns to each side.
constexpr int kSearchColumns = 360, kFollowSteps = 30, kAcquireSteps = 70;
/// Ground that begins lower, in picture heights, is too little to see a road on.
constexpr double kLowestHorizon = 0.9;
constexpr double kConfidenceMemory_s = 1.0;
/// Ground nearer than this, in parts of the way from the horizon to the bottom, is taken for flat.
constexpr float kHinge = 0.2F;

/// Of a first-order filter's way that it goes in a frame.
float part_in(double dt_s, double memory_s) { return static_cast<float>(1.0 - std::exp(-dt_s / memory_s)); }

}  // namespace

ColorRoad::ColorRoad(const RoadParams& params, const RoadPicture& picture, int history_depth)
    : params_(params),
      picture_(picture),
      stored_width_(picture.width_px / picture.shrink),
      stored_height_(picture.height_px / picture.shrink),
      far_motion_(4096),
      learner_(params, picture, history_depth),
      profile_(params.rows, stored_width_),
      search_(params.rows, std::max(1, stored_width_ / kSearchColumns), kAcquireSteps),
      filter_(params.rows),
      rise_(stored_width_) {
  rows_.resize(static_cast<std::size_t>(params.rows));
  expected_.resize(rows_.size());
  found_.resize(rows_.size());
  line_.reserve(rows_.size());
  reset();
}

void ColorRoad::reset() {
  learner_.clear();
  filter_.reset();
  following_ = false;
  line_.clear();
  risen_ = false;
  confidence_ = 0.0F;
  const double horizon_px =
      std::isfinite(picture_.horizon_row_px) ? picture_.horizon_row_px : 0.4 * picture_.height_px;
  shape_ = {static_cast<float>(horizon_px / picture_.shrink), 1.25F};
}

void ColorRoad::update(const RoadInput& input, RoadEstimate& estimate) {
  if (picture_.horizon_row_px > kLowestHorizon * picture_.height_px) {
    estimate.status = RoadStatus::no_horizon;
    estimate.horizon_row_px = picture_.horizon_row_px;
    return;
  }
  const ColorView picture{input.appearance.picture(0), stored_width_, stored_height_};
  learn(input, picture);
  if (following_) {
    follow(input, picture);
  } else if (frames_ % std::max(1L, std::lround(kAcquireEvery_s / std::max(input.dt_s, 1e-3))) == 0) {
    acquire(picture);
  }
  draw_line();
  look_up(picture);
  tell(estimate);
}

void ColorRoad::learn(const RoadInput& input, const ColorView& picture) {
  learner_.fade(input.dt_s);
  learner_.learn_definition(input, picture, shape_.horizon, ++frames_ % params_.refresh_frames == 0);
  if (following_) {
    learner_.learn_beside(picture, rows_, std::span(found_).first(risen_ ? flat_rows_ : line_.size()));
    if (risen_) learner_.learn_beside(picture, rise_.rows(), rise_.roads());
    learner_.learn_above(picture, shape_.horizon);
  } else {
    lay_rows(shape_);
    learner_.learn_beside_anything(picture, rows_, shape_.horizon);
  }
  learner_.refresh();
}

void ColorRoad::lay_rows(const RoadShape& shape) { lay_road_rows(shape, stored_height_, rows_); }

void ColorRoad::fill_profile(const ColorView& picture) {
  for (std::size_t k = 0; k < rows_.size(); ++k)
    profile_.fill(static_cast<int>(k), learner_.colors(), picture, rows_[k].top, rows_[k].bottom);
}

std::span<const FoundRoad> ColorRoad::search(const RoadShape& shape, bool acquiring) {
  const float bottom = static_cast<float>(stored_height_ - 1);
  const float middle = 0.5F * static_cast<float>(stored_width_);
  const float vehicle = static_cast<float>(params_.definition_centre) * static_cast<float>(stored_width_);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const float near = (rows_[k].row - shape.horizon) / (bottom - shape.horizon);
    const int row = static_cast<int>(k);
    if (acquiring) {
      expected_[k].middle_px = middle + near * (vehicle - middle);
    } else {
      expected_[k].middle_px = filter_.known(row)  ? filter_.middle_px(row)
                               : k < kStraightRows ? middle
                                                   : straight_on(rows_, expected_, k);
    }
    expected_[k].half_width_px = shape.half_width_px(rows_[k].row);
  }
  RoadSearchCosts costs;
  costs.bend = static_cast<float>(params_.bend_cost);
  costs.odd_width = acquiring ? 0.0F : kOddWidthCost;
  if (acquiring) costs.stray = 0.0F;
  return search_.find(profile_, expected_, acquiring ? kAcquireSteps : kFollowSteps, costs);
}

void ColorRoad::acquire(const ColorView& picture) {
  RoadShape best = shape_;
  float best_total = -1e9F;
  const bool calibrated = std::isfinite(picture_.horizon_row_px);
  for (std::size_t h = 0; h < (calibrated ? 1 : kHorizons.size()); ++h) {
    RoadShape shape;
    shape.horizon = calibrated ? static_cast<float>(picture_.horizon_row_px / picture_.shrink)
                               : kHorizons[h] * static_cast<float>(stored_height_);
    lay_rows(shape);
    fill_profile(picture);
    for (const float slope : kSlopes) {
      shape.slope = slope;
      search(shape, true);
      // Wide roads are measured in wide units.
      const float total = search_.total() * std::sqrt(slope);
      if (total <= best_total) continue;
      best_total = total;
      best = shape;
    }
  }
  shape_ = best;
  swing_ = 0.0F;
  for (int round = 0; round < kAcquireRounds; ++round) {
    lay_rows(shape_);
    fill_profile(picture);
    const auto found = search(shape_, true);
    refine(found);
    confidence_ = judge(found_);
    if (round + 1 < kAcquireRounds) adapt_shape(found_, kAcquireGain);
  }
  following_ = confidence_ >= static_cast<float>(params_.found_confidence);
  filter_.reset();
  if (following_) correct(found_);
}

void ColorRoad::follow(const RoadInput& input, const ColorView& picture) {
  const FarMotion far = far_motion_.find(input.flow, picture_.full_px(shape_.horizon),
                                         0.08F * static_cast<float>(picture_.height_px));
  const auto shrink = static_cast<float>(picture_.shrink);
  const float swing = (1.0F - part_in(input.dt_s, kSwingMemory_s)) * (swing_ + far.dy_px / shrink);
  shape_.horizon += swing - std::exchange(swing_, swing);
  filter_.predict(far.dx_px / shrink, static_cast<float>(params_.line_drift_per_s * std::sqrt(input.dt_s)));
  lay_rows(shape_);
  fill_profile(picture);
  refine(search(shape_, false));
  confidence_ += part_in(input.dt_s, kConfidenceMemory_s) * (judge(found_) - confidence_);
  correct(found_);
  adapt_shape(found_, part_in(input.dt_s, kShapeMemory_s));
  following_ = confidence_ >= static_cast<float>(params_.lost_confidence);
}

void ColorRoad::refine(std::span<const FoundRoad> found) {
  for (std::size_t k = 0; k < found.size(); ++k)
    found_[k] = refine_road(profile_, static_cast<int>(k), found[k], expected_[k].half_width_px);
}

/// Mean contrast over the visible rows, each as wide as it is; counts the visible rows.
float ColorRoad::judge(std::span<const FoundRoad> found) {
  float near = 0.0F;
  for (std::size_t k = 0; k < found.size() / 2; ++k)
    near += found[k].fit / static_cast<float>(found.size() / 2);
  const float least = std::min(kVisibleFit, kVisibleShare * near);
  float sum = 0.0F, best = 0.0F;
  visible_rows_ = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    // Where it looks alike inside and beside, it is the look that tells road from sky.
    const float left = found[k].middle_px - found[k].half_width_px,
                right = found[k].middle_px + found[k].half_width_px;
    const float inside = profile_.between(static_cast<int>(k), left, right) / (right - left);
    sum += inside < kUnlike ? inside : found[k].fit - least;
    if (sum < best) continue;
    best = sum;
    visible_rows_ = static_cast<int>(k) + 1;
  }
  float contrast = 0.0F, weight = 1e-6F;
  for (std::size_t k = 0; k < static_cast<std::size_t>(visible_rows_); ++k) {
    if (!is_whole(found[k], stored_width_)) continue;
    contrast += 0.5F * found[k].contrast;
    weight += 1.0F;
  }
  return std::clamp(contrast / weight, 0.0F, 1.0F);
}

void ColorRoad::correct(std::span<const FoundRoad> found) {
  for (std::size_t k = 0; k < found.size(); ++k) {
    const int row = static_cast<int>(k);
    if (row >= visible_rows_) {
      filter_.forget(row);
      continue;
    }
    filter_.correct(row, found[k].middle_px, found[k].half_width_px, shape_.half_width_px(rows_[k].row),
                    kRowSigma / std::max(found[k].fit, kLeastFit));
  }
}

void ColorRoad::adapt_shape(std::span<const FoundRoad> found, float gain) {
  const auto fit = fit_road_shape(rows_, found.first(static_cast<std::size_t>(visible_rows_)), stored_width_);
  if (!fit) return;
  const float off = fit->horizon - shape_.horizon;
  const float deepest = static_cast<float>(stored_height_ - 1) - shape_.horizon;
  if (fit->slope < 0.3F * shape_.slope || fit->slope > 3.0F * shape_.slope ||
      std::abs(off) > kMostOffHorizon * deepest)
    return;
  shape_.slope += gain * (fit->slope - shape_.slope);
  shape_.horizon += gain * (std::isfinite(picture_.horizon_row_px) ? kCalibratedPart : 1.0F) * off;
}

/// The road on flat ground, as the filter has it.
void ColorRoad::draw_line() {
  line_.clear();
  for (int row = 0; following_ && row < visible_rows_; ++row) {
    const float half_px = shape_.half_width_px(rows_[static_cast<std::size_t>(row)].row);
    line_.push_back({filter_.middle_px(row), half_px * filter_.width_ratio(row), 0.0F, 0.0F});
  }
}

/// Looks for the road on rising ground, beyond the rows that are near enough to be taken for flat. Where the
/// horizon is itself made out of the rows' widths, rising ground cannot be told from a wrong one.
void ColorRoad::look_up(const ColorView& picture) {
  risen_ = false;
  if (!std::isfinite(picture_.horizon_row_px)) return;
  const float nearest = shape_.horizon + kHinge * (static_cast<float>(stored_height_ - 1) - shape_.horizon);
  std::size_t hinge = 0;
  for (std::size_t k = 0; k < line_.size(); ++k) {
    if (rows_[k].row > nearest) hinge = k;
  }
  if (hinge == 0) return;
  flat_rows_ = hinge + 1;
  risen_ = rise_.find({shape_.horizon, std::span(rows_).subspan(hinge, line_.size() - hinge),
                       std::span(line_).subspan(hinge)},
                      learner_.colors(), picture, static_cast<std::size_t>(kMostRoadRows) - flat_rows_);
}

void ColorRoad::tell(RoadEstimate& estimate) const {
  estimate.status = following_ ? RoadStatus::following : RoadStatus::no_road;
  estimate.confidence = static_cast<double>(confidence_);
  estimate.horizon_row_px = static_cast<double>(picture_.full_px(shape_.horizon));
  estimate.count = 0;
  const auto add = [&](std::span<const SearchRow> rows, std::span<const FoundRoad> roads) {
    for (std::size_t k = 0; k < roads.size(); ++k) {
      const float middle = roads[k].middle_px, half = roads[k].half_width_px;
      estimate.row[static_cast<std::size_t>(estimate.count++)] = {
          picture_.full_px(rows[k].row), picture_.full_px(middle - half), picture_.full_px(middle + half)};
    }
  };
  add(rows_, std::span(line_).first(risen_ ? flat_rows_ : line_.size()));
  if (risen_) add(rise_.rows(), rise_.roads());
}

}  // namespace hindsight
