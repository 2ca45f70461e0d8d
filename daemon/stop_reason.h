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
  watching = 13,       ///< the mode is `watch`
  thread = 14,         ///< a thread of the process died or hangs
  bumper_left_stuck = 15,   ///< pressed ever since its line was opened
  bumper_right_stuck = 16,
  gps = 17             ///< no fix for too long, after there was one
};
constexpr int kStopReasonCount = 18;

/// Whether something went wrong, so that the seconds before are worth keeping. An e-stop counts: somebody had to.
constexpr bool is_fault(StopReason reason) {
  switch (reason) {
    case StopReason::estop:
    case StopReason::camera:
    case StopReason::can_bus:
    case StopReason::wheels:
    case StopReason::gpio:
    case StopReason::stale_command:
    case StopReason::bad_command:
    case StopReason::overruns:
    case StopReason::thread:
    case StopReason::gps:
      return true;
    case StopReason::none:
    case StopReason::not_armed:
    case StopReason::operator_stop:
    case StopReason::bumper:
    case StopReason::shutdown:
    case StopReason::watching:
    case StopReason::bumper_left_stuck:
    case StopReason::bumper_right_stuck:
      break;
  }
  return false;
}

constexpr const char* name_of(StopReason reason) {
  constexpr const char* names[kStopReasonCount] = {
      "none", "not armed", "operator stop", "e-stop", "camera", "CAN bus", "wheel encoders",
      "GPIO lines", "stale command", "bumper", "bad command", "overruns", "shutdown", "watch mode",
      "thread lost", "left bumper stuck", "right bumper stuck", "GPS lost"};
  return names[static_cast<int>(reason)];
}

}  // namespace hindsight
