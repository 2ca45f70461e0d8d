// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_line_filter.h"

#include <algorithm>
#include <cmath>

namespace hindsight {

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
  const float log_width = std::log(half_width_px / expected_half_width_px);
  if (!state.known) {
    state = {true, middle_px, log_width, sigma * sigma};
    return;
  }
  const float gain = state.variance / (state.variance + sigma * sigma);
  state.middle_px += gain * (middle_px - state.middle_px);
  state.log_width += gain * (log_width - state.log_width);
  state.variance *= 1.0F - gain;
}

float RoadLineFilter::width_ratio(int row) const {
  return std::exp(states_[static_cast<std::size_t>(row)].log_width);
}

}  // namespace hindsight
