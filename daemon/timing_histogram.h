// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "drivers/samples.h"

namespace hindsight {

/// How often a duration was how long, in bins of fixed, growing width: two an octave from 1 us on, the last
/// one open (786 ms and more). Adding allocates nothing.
class TimingHistogram {
 public:
  static constexpr std::size_t kBins = 40;

  void add(Time duration) { ++counts_[bin_of(duration)]; }
  const std::array<std::int32_t, kBins>& counts() const { return counts_; }

  /// Where a bin begins: 1, 1.5, 2, 3, 4, 6, 8, 12 us and so on. The second bin is empty: durations are whole
  /// us.
  static constexpr double lower_edge_us(std::size_t bin) {
    const double octave = static_cast<double>(std::uint64_t{1} << (bin / 2));
    return bin % 2 == 0 ? octave : 1.5 * octave;
  }

 private:
  static std::size_t bin_of(Time duration) {
    const auto us = static_cast<std::uint64_t>(std::max<Time::rep>(duration.count() / 1000, 1));
    const auto octave = static_cast<std::size_t>(std::bit_width(us)) - 1;
    const std::size_t half = octave > 0 ? (us >> (octave - 1)) & 1U : 0;
    return std::min(2 * octave + half, kBins - 1);
  }

  std::array<std::int32_t, kBins> counts_{};
};

}  // namespace hindsight
