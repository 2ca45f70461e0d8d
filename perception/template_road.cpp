// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/template_road.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hindsight {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
/// Where a strip would hang over the picture's edge nothing is known: as bad as a match gets.
constexpr float kNoMatch = 2.0F;
/// A line this near to the picture's upper or lower border, in parts of its height, is no horizon.
constexpr float kBorder = 0.04F;
/// What a horizon between sky and ground explains at least.
constexpr float kExplains = 0.2F;

}  // namespace

TemplateRoad::TemplateRoad(const RoadParams& params, const RoadPicture& picture, int history_depth)
    : params_(params),
      picture_(picture),
      match_(params.match == "correlation" ? TemplateMatch::correlation : TemplateMatch::squared_difference),
      stored_width_(picture.width_px / picture.shrink),
      stored_height_(picture.height_px / picture.shrink),
      definition_(params, picture, history_depth),
      horizon_finder_(stored_width_, stored_height_),
      far_motion_(4096),
      horizons_px_(static_cast<std::size_t>(history_depth) + 1, kNan) {
  const int height = std::max(1, params.definition_height_px / picture.shrink);
  const auto count = static_cast<std::size_t>(params.templates);
  const auto width = static_cast<std::size_t>(stored_width_);
  for (std::size_t i = 0; i < count; ++i)
    templates_.push_back({TemplateRow(stored_width_, widest_template(), height), {}});
  responses_.resize(count * width);
  lines_.reserve(count);
  cost_.resize(width);
  cost_before_.resize(width);
  link_.resize(count * width);
  path_.resize(count);
}

/// What is farther away is not wider.
int TemplateRoad::widest_template() const {
  return static_cast<int>(definition_.region().width_px()) / picture_.shrink + 1;
}

void TemplateRoad::reset() {
  std::fill(horizons_px_.begin(), horizons_px_.end(), kNan);
  for (Template& t : templates_) t.taken = false;
  frames_ = 0;
}

float TemplateRoad::horizon_px(int frames_back) const {
  const int size = static_cast<int>(horizons_px_.size());
  return horizons_px_[static_cast<std::size_t>((newest_ - frames_back + size) % size)];
}

void TemplateRoad::find_horizon(const RoadInput& input) {
  float& horizon = horizons_px_[static_cast<std::size_t>(newest_)];
  const auto height = static_cast<float>(picture_.height_px);
  if (params_.horizon == "flow") {
    float before = horizon_px(1);
    if (!std::isfinite(before)) {
      before = std::isfinite(picture_.horizon_row_px) ? static_cast<float>(picture_.horizon_row_px)
                                                      : 0.4F * height;
    }
    horizon = before + far_motion_.find(input.flow, before, 0.08F * height).dy_px;
    return;
  }
  const HorizonLine line = horizon_finder_.find({input.appearance.picture(0), stored_width_, stored_height_});
  const float row = line.middle_row_px * static_cast<float>(picture_.shrink);
  const bool in_view =
      row > kBorder * height && row < (1.0F - kBorder) * height && line.explained > kExplains;
  horizon = in_view ? row : kNan;
}

void TemplateRoad::update(const RoadInput& input, RoadEstimate& estimate) {
  newest_ = (newest_ + 1) % static_cast<int>(horizons_px_.size());
  find_horizon(input);
  estimate.horizon_row_px = static_cast<double>(horizon_px(0));
  estimate.confidence = 0.0;
  estimate.count = 0;
  if (frames_++ % params_.refresh_frames == 0) refresh(input);
  search(input);
  if (lines_.empty()) {
    estimate.status = std::isfinite(horizon_px(0)) ? RoadStatus::no_road : RoadStatus::no_horizon;
    return;
  }
  estimate.status = RoadStatus::following;
  find_path();
  const auto shrink = static_cast<float>(picture_.shrink);
  const RoadStrip& region = definition_.region();
  // From the vehicle on, which stands on it.
  estimate.row[0] = {static_cast<float>(picture_.height_px - 1), region.left_px, region.right_px};
  estimate.count = 1;
  double fit = 0.0;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const float middle = static_cast<float>(path_[i]) * shrink, half = 0.5F * lines_[i].width_px;
    estimate.row[static_cast<std::size_t>(estimate.count++)] = {lines_[i].row_px, middle - half,
                                                                middle + half};
    fit += static_cast<double>(std::max(0.0F, 1.0F - cost_at(lines_[i], path_[i])));
  }
  estimate.confidence = fit / static_cast<double>(lines_.size());
}

void TemplateRoad::refresh(const RoadInput& input) {
  for (Template& t : templates_) t.taken = false;
  const auto shrink = static_cast<float>(picture_.shrink);
  auto next = templates_.begin();
  for (const RoadStrip& strip : definition_.trace(input.history, params_.templates)) {
    if (strip.frames_back >= input.appearance.size()) continue;
    const int height = std::max(1, params_.definition_height_px / picture_.shrink);
    const int left = std::clamp(static_cast<int>(strip.left_px / shrink), 0, stored_width_ - 1);
    const int right = std::clamp(static_cast<int>(strip.right_px / shrink), 0, stored_width_);
    const int top = static_cast<int>(std::lround(strip.top_px / shrink));
    if (right - left < 2 || right - left > widest_template() || top < 0 || top + height > stored_height_)
      continue;
    next->row.take({input.appearance.picture(strip.frames_back), stored_width_, stored_height_}, left, top,
                   right - left, height);
    next->strip = strip;
    next->horizon_px = horizon_px(strip.frames_back);
    next->taken = true;
    ++next;
  }
}

void TemplateRoad::search(const RoadInput& input) {
  const ColorView picture{input.appearance.picture(0), stored_width_, stored_height_};
  const auto shrink = static_cast<float>(picture_.shrink);
  lines_.clear();
  for (Template& t : templates_) {
    if (!t.taken) continue;
    // Without a horizon in view nothing is known of the pitch.
    const float pitch_px = horizon_px(0) - t.horizon_px;
    const float top_px = t.strip.top_px + (std::isfinite(pitch_px) ? pitch_px : 0.0F);
    const int top = static_cast<int>(std::lround(top_px / shrink));
    if (top < 0 || top + t.row.height_px() > stored_height_) continue;
    const auto response = t.row.search(picture, top, match_);
    float* kept = &responses_[lines_.size() * static_cast<std::size_t>(stored_width_)];
    std::copy(response.begin(), response.end(), kept);
    lines_.push_back({top_px + 0.5F * static_cast<float>(params_.definition_height_px), t.strip.width_px(),
                      std::span<const float>(kept, response.size())});
  }
}

float TemplateRoad::cost_at(const SearchLine& line, int column) const {
  const int left = column - (stored_width_ - static_cast<int>(line.response.size()) + 1) / 2;
  const bool inside = left >= 0 && left < static_cast<int>(line.response.size());
  return inside ? line.response[static_cast<std::size_t>(left)] : kNoMatch;
}

/// From the topmost line down: the cost of each place is its match plus the least cost within the window on
/// the line above.
void TemplateRoad::find_path() {
  const int reach = std::max(1, params_.window_px / picture_.shrink);
  const auto width = static_cast<std::size_t>(stored_width_);
  for (std::size_t line = lines_.size(); line-- > 0;) {
    std::swap(cost_, cost_before_);
    for (int x = 0; x < stored_width_; ++x) {
      float above = 0.0F;
      if (line + 1 < lines_.size()) {
        const auto begin = cost_before_.begin() + std::max(0, x - reach);
        const auto end = cost_before_.begin() + std::min(stored_width_, x + reach + 1);
        const auto best = std::min_element(begin, end);
        link_[line * width + static_cast<std::size_t>(x)] =
            static_cast<std::uint16_t>(best - cost_before_.begin());
        above = *best;
      }
      cost_[static_cast<std::size_t>(x)] = cost_at(lines_[line], x) + above;
    }
  }
  path_[0] = static_cast<int>(std::min_element(cost_.begin(), cost_.end()) - cost_.begin());
  for (std::size_t line = 0; line + 1 < lines_.size(); ++line)
    path_[line + 1] = link_[line * width + static_cast<std::size_t>(path_[line])];
}

}  // namespace hindsight
