// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "faulty_drive.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "fault_schedule.h"

namespace hindsight::endurance {
namespace {

constexpr Time kOrderEvery = std::chrono::seconds(1);
/// A fault's consequences come within this time of its end (a camera may still be fresh when it ends), and
/// the operator gets the vehicle going again within that.
constexpr Time kAftermath = from_seconds(0.6), kRecovery = from_seconds(3.5);
/// A source that is silent for so long must have stopped the vehicle, and within so much of it.
constexpr Time kLongSilence = from_seconds(1.0);
constexpr double kLatestStop_s = 0.6;

bool stops(StopReason reason, Source source) {
  if (source == Source::camera) return reason == StopReason::camera;
  if (source == Source::can) return reason == StopReason::wheels || reason == StopReason::can_bus;
  return reason == StopReason::gpio;
}

}  // namespace

FaultyDrive::FaultyDrive(const World& world, std::uint64_t seed, const std::vector<FaultSpec>& faults)
    : faults_(faults),
      run_({.configuration = {},
            .world = world,
            .seed = seed,
            .mixture = {},
            .disturb = [this](TickInput& input) { disturb(input); }}) {
  for (const FaultSpec& fault : faults) outcomes_.push_back({.fault = fault});
}

void FaultyDrive::disturb(TickInput& input) {
  if (!began_) began_ = input.now;
  operate(input);
  faults_.inject(input);
}

/// Arms again once a second while nothing is broken and the vehicle is not allowed to move; what made an
/// e-stop of a broken line is released first.
void FaultyDrive::operate(TickInput& input) {
  const bool stopped = run_.decision().reason != StopReason::none;
  if (!stopped || any_lasts(elapsed(input.now)) || input.now - last_order_ < kOrderEvery) return;
  last_order_ = input.now;
  input.commands.push_back({input.now, CommandKind::release_estop, 0.0, 0.0, ++orders_});
  input.commands.push_back({input.now, CommandKind::arm, 0.0, 0.0, ++orders_});
}

bool FaultyDrive::any_lasts(Time elapsed) const {
  return std::ranges::any_of(outcomes_, [&](const FaultOutcome& outcome) {
    return elapsed >= outcome.fault.begin && elapsed < outcome.fault.begin + outcome.fault.length;
  });
}

void FaultyDrive::step() {
  const StopReason forbidden = run_.decision().reason;
  run_.step(
      tools::SimFault::none, [&](Time now, const SimVehicle&, const std::optional<WheelCommand>& command) {
        if (forbidden == StopReason::none || !command ||
            (command->left_mps == 0.0F && command->right_mps == 0.0F))
          return;
        throw std::runtime_error(fmt::format("{:.2f} s: {:g} and {:g} m/s went out although forbidden: {}",
                                             to_seconds(elapsed(now)), command->left_mps, command->right_mps,
                                             name_of(forbidden)));
      });
  judge();
}

void FaultyDrive::judge() {
  const Time now = elapsed(run_.input().now);
  const StopReason reason = run_.decision().reason;
  for (FaultOutcome& outcome : outcomes_) {
    const Time since = now - outcome.fault.begin;
    if (since < Time{} || since > outcome.fault.length + kRecovery) continue;
    if (outcome.reason == StopReason::none && since < outcome.fault.length + kAftermath) {
      outcome.reason = reason;
      outcome.stopped_after_s = to_seconds(since);
    }
    outcome.armed_again = reason == StopReason::none;
  }
}

std::string complaint(const FaultOutcome& outcome) {
  const FaultSpec& fault = outcome.fault;
  if (!outcome.armed_again) return "could not be armed again";
  if (fault.kind != FaultKind::off || fault.source == Source::gps || fault.length < kLongSilence) return "";
  if (!stops(outcome.reason, fault.source)) return fmt::format("stop reason is {}", name_of(outcome.reason));
  if (outcome.stopped_after_s > kLatestStop_s) return fmt::format("stopped late");
  return "";
}

}  // namespace hindsight::endurance
