// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/road_horizon.h"

#include <limits>

namespace hindsight {
namespace {

constexpr double kVeryFar_m = 1e6;

}  // namespace

double horizon_row_px(const CameraModel& camera) {
  const auto pixel = camera.project({kVeryFar_m, 0.0, 0.0});
  return pixel ? pixel->y_px : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace hindsight
