// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_line_filter.h"

#include <algorithm>

namespace hindsight {
namespace {

/// An edge is moved as if it had been seen at most so far from where it was, in half widths: the mouth of a
/// side road passes before its edge has been followed into it.
constexpr float kMostInnovation = 0.3F;

}  // namespace

RoadLineFilter::RoadLineFilter(int rows) : states_(static_cast<std::size_t>(rows)) {}

void RoadLineFilter::reset() { std::fill(states_.begin(), states_.end(), State{}); }

void RoadLineFilter::predict(float dx_px, float sigma) {
  for (State& state : states_) {
    state.middle_px += dx_px;
    state.variance += sigma * sigma;
  }
}

void RoadLineFilter::correct(int row, float middle_px, float half_width_px, float expected_half_width_px,
                             float sigma) {
  State& state = states_[static_cast<std::size_t>(row)];
  if (!state.known) {
    state = {true, middle_px, half_width_px / expected_half_width_px, sigma * sigma};
    return;
  }
  const float gain = state.variance / (state.variance + sigma * sigma);
  const float half_px = state.width_ratio * expected_half_width_px;
  const float most_px = kMostInnovation * expected_half_width_px;
  const auto limited = [&](float innovation_px) { return std::clamp(innovation_px, -most_px, most_px); };
  const float left_px = limited(middle_px - half_width_px - (state.middle_px - half_px));
  const float right_px = limited(middle_px + half_width_px - (state.middle_px + half_px));
  state.middle_px += gain * 0.5F * (left_px + right_px);
  state.width_ratio += gain * 0.5F * (right_px - left_px) / expected_half_width_px;
  state.variance *= 1.0F - gain;
}

}  // namespace hindsight
