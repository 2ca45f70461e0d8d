// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/far_motion.h"

#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

constexpr std::size_t kFewestVectors = 8;

float median_of(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

FarMotionFinder::FarMotionFinder(int max_vectors) {
  dx_px_.reserve(static_cast<std::size_t>(max_vectors));
  dy_px_.reserve(static_cast<std::size_t>(max_vectors));
}

FarMotion FarMotionFinder::find(std::span<const FlowVector> flow_t_to_t_minus_1, float horizon_row_px,
                                float reach_px) {
  dx_px_.clear();
  dy_px_.clear();
  for (const FlowVector& v : flow_t_to_t_minus_1) {
    if (std::abs(v.y_px - horizon_row_px) > reach_px || dx_px_.size() == dx_px_.capacity()) continue;
    dx_px_.push_back(-v.dx_px);
    dy_px_.push_back(-v.dy_px);
  }
  if (dx_px_.size() < kFewestVectors) return {};
  return {median_of(dx_px_), median_of(dy_px_), static_cast<int>(dx_px_.size())};
}

}  // namespace hindsight
