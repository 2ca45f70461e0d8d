// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/wheel_way.h"

#include <cmath>

namespace hindsight {
namespace {

constexpr Time kLongestGap = from_seconds(0.2);
constexpr Time kLongestLag = from_seconds(0.1);

}  // namespace

void WheelWay::add(Time stamp, const Wheels& speeds_mps) {
  if (!std::isfinite(speeds_mps[0]) || !std::isfinite(speeds_mps[1])) return;
  Sample sample{stamp, speeds_mps, {}};
  if (held_ > 0) {
    const Sample& last = back(0);
    if (stamp <= last.stamp) return;
    if (stamp - last.stamp > kLongestGap) held_ = 0;
    for (std::size_t i = 0; i < sample.way_m.size(); ++i) {
      sample.way_m[i] =
          last.way_m[i] + 0.5 * (last.speeds_mps[i] + speeds_mps[i]) * to_seconds(stamp - last.stamp);
    }
  }
  samples_[next_] = sample;
  next_ = (next_ + 1) % kSamples;
  if (held_ < kSamples) ++held_;
}

std::optional<WheelWay::Wheels> WheelWay::between(Time from, Time to) const {
  const auto first = at(from), last = at(to);
  if (!first || !last) return std::nullopt;
  return Wheels{(*last)[0] - (*first)[0], (*last)[1] - (*first)[1]};
}

/// From the newest sample that is not later, at the speed that it had.
std::optional<WheelWay::Wheels> WheelWay::at(Time time) const {
  for (std::size_t i = 0; i < held_; ++i) {
    const Sample& sample = back(i);
    if (sample.stamp > time) continue;
    if (i == 0 && time - sample.stamp > kLongestLag) return std::nullopt;
    const double since_s = to_seconds(time - sample.stamp);
    return Wheels{sample.way_m[0] + sample.speeds_mps[0] * since_s,
                  sample.way_m[1] + sample.speeds_mps[1] * since_s};
  }
  return std::nullopt;
}

}  // namespace hindsight
