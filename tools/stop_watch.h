// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>

#include "sim_replay/vehicle/sim_vehicle.h"

namespace hindsight::tools {

/// How a vehicle comes to a stand after something broke: shown each of its periods from then on.
class StopWatch {
 public:
  /// Slower than this it stands, if it stays so.
  static constexpr double kStands_mps = 0.01;

  /// way_m: driven since start.
  void begin(Time now, double way_m) { began_ = now, began_m_ = way_m; }
  void see(Time now, double speed_mps, double way_m, const std::optional<WheelCommand>& command);

  /// From the beginning until the wheels were told nothing but zero, or nothing at all; empty if they were
  /// not.
  std::optional<double> to_zero_s() const { return zero_s_; }
  /// Until it stood for good; empty if it does not.
  std::optional<double> to_standstill_s() const { return stand_s_; }
  /// Rolled since the beginning, until it stood for good or was last seen.
  double rolled_m() const { return rolled_m_; }

 private:
  Time began_{};
  double began_m_ = 0.0;
  double rolled_m_ = 0.0;
  std::optional<double> zero_s_;
  std::optional<double> stand_s_;
};

}  // namespace hindsight::tools
