// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// How much evidence a new object needs, where a map tells how things move there.
#pragma once

#include <algorithm>

#include "perception/particle_filter.h"

namespace hindsight {

/// In parts of what it needs without a map, 1 for null: what moves where and as things usually do is believed
/// sooner, what moves where the map has looked for long and seen nothing like it, later. The map's log ratio
/// counts as so much of the evidence of kEvidence that is wanted; less than half is never enough, as the
/// map knows nothing of errors of the flow.
inline double motion_demand(const MotionPrior* prior, Point2f at_px, Point2f v_px) {
  constexpr double kEvidence = 6.0, kLeast = 0.5, kMost = 2.0;
  if (prior == nullptr) return 1.0;
  return std::clamp(1.0 - prior->log_ratio(at_px, v_px) / kEvidence, kLeast, kMost);
}

}  // namespace hindsight
