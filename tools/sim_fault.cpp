// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/sim_fault.h"

#include <vector>

namespace hindsight::tools {

namespace {

/// What says nothing any more.
std::optional<Source> silent_source(SimFault fault) {
  switch (fault) {
    case SimFault::bus_cut:
    case SimFault::bus_silent:
      return Source::can;
    case SimFault::camera_off:
      return Source::camera;
    case SimFault::lines_failed:
      return Source::gpio;
    case SimFault::gps_off:
      return Source::gps;
    case SimFault::none:
    case SimFault::killed:
    case SimFault::loop_hangs:
    case SimFault::wheels_off:
      break;
  }
  return std::nullopt;
}

}  // namespace

const char* name_of(SimFault fault) {
  constexpr std::array kNames{"none",       "process killed",      "loop hangs",         "CAN bus cut",
                              "CAN silent", "wheel encoders stop", "camera frames stop", "GPIO lines fail",
                              "GPS lost"};
  return kNames[static_cast<std::size_t>(fault)];
}

void FaultInjector::inject(SimFault fault, TickInput& input) {
  if (fault == SimFault::wheels_off) {
    std::erase_if(input.can,
                  [&](const CanFrame& frame) { return decoder_.decode(frame).has(SignalGroup::wheels); });
  }
  const std::optional<Source> source = silent_source(fault);
  if (!source) return;
  if (!silence_) silence_.emplace(std::vector{FaultSpec{*source, FaultKind::off, Time{}, Time::max()}});
  silence_->inject(input);
}

}  // namespace hindsight::tools
