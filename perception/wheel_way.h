// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "drivers/samples.h"

namespace hindsight {

/// How far each wheel rolled between two times: its speed, integrated. Remembers 128 samples. No allocation.
class WheelWay {
 public:
  using Wheels = std::array<double, 2>;  ///< left, right

  /// Speeds in the order of time. One that is not finite, or not later than the last, is ignored; after a gap
  /// of more than 0.2 s nothing is known of what was before.
  void add(Time stamp, const Wheels& speeds_mps);

  /// Forward positive. Empty where no samples reach from one to the other, give or take 0.1 s at the newer
  /// end.
  std::optional<Wheels> between(Time from, Time to) const;

 private:
  struct Sample {
    Time stamp{};
    Wheels speeds_mps{};
    Wheels way_m{};
  };
  static constexpr std::size_t kSamples = 128;

  const Sample& back(std::size_t i) const { return samples_[(next_ + kSamples - 1 - i) % kSamples]; }
  std::optional<Wheels> at(Time time) const;

  std::array<Sample, kSamples> samples_;
  std::size_t next_ = 0;
  std::size_t held_ = 0;
};

}  // namespace hindsight
