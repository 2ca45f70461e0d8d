// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/vehicle/wheel_encoder.h"

#include <cmath>

namespace hindsight {
namespace {

constexpr double kScaleSigma = 0.003;
constexpr double kSmoothing_s = 0.04;
/// Without ticks, a speed that is smaller than one tick a second has ended.
constexpr double kEnded_mps = 1.0 / WheelEncoder::kTicksPerMetre;

}  // namespace

WheelEncoder::WheelEncoder(Random random) : scale_(1.0 + kScaleSigma * random.normal()) {}

void WheelEncoder::report(double way_m, double period_s) {
  const double count = std::floor(way_m * scale_ * kTicksPerMetre);
  const double raw_mps = (count - count_) / kTicksPerMetre / period_s;
  count_ = count;
  speed_mps_ += (1.0 - std::exp(-period_s / kSmoothing_s)) * (raw_mps - speed_mps_);
  if (raw_mps == 0.0 && std::abs(speed_mps_) < kEnded_mps) speed_mps_ = 0.0;
}

double WheelEncoder::ticks() const { return count_ - kTicksWrap * std::floor(count_ / kTicksWrap); }

}  // namespace hindsight
