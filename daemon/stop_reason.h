// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace hindsight {

/// Why the vehicle may not move. Numbers are published and logged: append, never renumber.
enum class StopReason : std::uint8_t {
  none = 0,
  not_armed = 1,
  operator_stop = 2,
  estop = 3,
  camera = 4,         ///< no fresh frame
  can_bus = 5,        ///< bus down, bus-off or silent
  wheels = 6,         ///< encoder samples stale
  gpio = 7,           ///< bumper and e-stop lines can not be read
  stale_command = 8,  ///< the loop has not spoken for too long
  bumper = 9,         ///< forward motion against a pressed bumper, or before the loop knew of the touch
  bad_command = 10,   ///< a set-point that is not a finite number
  overruns = 11,      ///< too many late ticks in a row
  shutdown = 12,
  watching = 13        ///< the mode is `watch`
};
constexpr int kStopReasonCount = 14;

constexpr const char* name_of(StopReason reason) {
  constexpr const char* names[kStopReasonCount] = {
      "none", "not armed", "operator stop", "e-stop", "camera", "CAN bus", "wheel encoders",
      "GPIO lines", "stale command", "bumper", "bad command", "overruns", "shutdown", "watch mode"};
  return names[static_cast<int>(reason)];
}

}  // namespace hindsight
