// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "sim_replay/world/random.h"

namespace hindsight {

/// Counts ticks of one wheel and makes a speed of them, as bases do: ticks of a report's period, smoothed.
class WheelEncoder {
 public:
  static constexpr double kTicksPerMetre = 2000.0;
  static constexpr double kTicksWrap = 4096.0;

  /// Draws the wheel's radius: nobody knows it better than to a few thousandths.
  explicit WheelEncoder(Random random);

  /// What it says of a wheel that has rolled `way_m` since start, `period_s` after its last report.
  void report(double way_m, double period_s);
  double speed_mps() const { return speed_mps_; }
  /// Cumulative, wrapped.
  double ticks() const;

 private:
  double scale_;
  double count_ = 0.0;
  double speed_mps_ = 0.0;
};

}  // namespace hindsight
