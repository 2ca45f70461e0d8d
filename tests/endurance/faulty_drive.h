// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/sim_run.h"

namespace hindsight::endurance {

/// What became of one fault.
struct FaultOutcome {
  FaultSpec fault;
  StopReason reason = StopReason::none;  ///< that it stopped the vehicle for; none: it drove on
  double stopped_after_s = 0.0;
  bool armed_again = true;
};

/// A simulated drive through faults, with an operator who arms again after each. No clock: the same world and
/// faults give the same drive.
class FaultyDrive {
 public:
  FaultyDrive(const World& world, std::uint64_t seed, const std::vector<FaultSpec>& faults);

  /// The next tick. Throws std::runtime_error that says when and what, where a command other than zero went
  /// out while motion was forbidden.
  void step();
  Time elapsed() const { return elapsed(run_.input().now); }
  const std::vector<FaultOutcome>& outcomes() const { return outcomes_; }
  tools::SimSummary summary() const { return run_.summary(); }

 private:
  void disturb(TickInput& input);
  void operate(TickInput& input);
  void judge();
  bool any_lasts(Time elapsed) const;
  /// Since the first tick, as faults count.
  Time elapsed(Time now) const { return began_ ? now - *began_ : Time{}; }

  std::vector<FaultOutcome> outcomes_;
  SampleFaults faults_;  // before the run that holds its pictures
  tools::SimRun run_;
  std::optional<Time> began_;
  Time last_order_{};
  std::int64_t orders_ = 100;  ///< beyond the drive's own
};

/// What is wrong with how a fault was met, or empty: one that keeps a required source silent for a second
/// must stop the vehicle, in time and for that reason; and the operator gets it going again.
std::string complaint(const FaultOutcome& outcome);

}  // namespace hindsight::endurance
