// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "drivers/samples.h"

namespace hindsight {

/// Signals that belong together and are fresh together.
enum class SignalGroup : std::uint8_t { wheels, ticks, currents, ir_ranges, battery, imu };
constexpr int kSignalGroupCount = 6;

/// A set of groups.
class SignalGroups {
 public:
  constexpr bool has(SignalGroup group) const { return (bits_ & bit(group)) != 0; }
  constexpr void add(SignalGroup group) { bits_ = static_cast<std::uint8_t>(bits_ | bit(group)); }
  constexpr bool empty() const { return bits_ == 0; }

 private:
  static constexpr unsigned bit(SignalGroup group) { return 1U << static_cast<unsigned>(group); }
  std::uint8_t bits_ = 0;
};

/// What the bus says of its own state, and what was wrong with the frames of our messages, counted since
/// start.
struct BusHealth {
  std::uint32_t good_frames = 0;
  std::uint32_t bad_checksums = 0;    ///< or of a wrong length
  std::uint32_t bad_counters = 0;     ///< repeated or skipped
  std::uint32_t bad_values = 0;       ///< outside the limits that the DBC file declares
  std::uint32_t consecutive_bad = 0;  ///< in a row, of the message that has the most at present
  std::uint32_t error_frames = 0;
  std::uint32_t bus_offs = 0;
  bool bus_off = false;              ///< until the controller says that it was restarted
  std::uint8_t transmit_errors = 0;  ///< the controller's error counters as it last told them
  std::uint8_t receive_errors = 0;
};

/// The latest good value of each signal. A stamp of zero: never received, values are meaningless then.
struct VehicleSignals {
  Time wheels_stamp{};
  double left_mps = 0.0;  ///< forward positive
  double right_mps = 0.0;
  Time ticks_stamp{};
  double left_ticks = 0.0;  ///< cumulative, wraps at the signal's width
  double right_ticks = 0.0;
  Time currents_stamp{};
  double left_a = 0.0;
  double right_a = 0.0;
  Time ir_stamp{};
  double ir_left_m = 0.0;  ///< the sensor's longest range where it sees nothing
  double ir_right_m = 0.0;
  Time battery_stamp{};
  double battery_v = 0.0;
  Time imu_stamp{};
  double yaw_rate_radps = 0.0;  ///< counter-clockwise from above
  BusHealth bus{};
};

}  // namespace hindsight
