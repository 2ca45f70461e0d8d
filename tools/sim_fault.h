// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What can break in a robot under way, put in through the seams that samples come through.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "daemon/robot_config.h"
#include "drivers/dbc.h"
#include "drivers/tick_input.h"
#include "drivers/vehicle_decoder.h"
#include "sim_replay/sample_faults.h"

namespace hindsight::tools {

enum class SimFault : std::uint8_t {
  none,
  killed,        ///< the process is gone: nothing is decided, nothing goes to the bus
  loop_hangs,    ///< nothing is decided; the reflex goes on
  bus_cut,       ///< nothing comes from the bus, nothing gets there
  bus_silent,    ///< nothing comes from the bus
  wheels_off,    ///< encoder messages stop
  camera_off,    ///< frames stop
  lines_failed,  ///< the GPIO chip reports failure
  gps_off        ///< fixes stop
};
inline constexpr std::array kSimFaults{SimFault::killed,       SimFault::loop_hangs, SimFault::bus_cut,
                                       SimFault::bus_silent,   SimFault::wheels_off, SimFault::camera_off,
                                       SimFault::lines_failed, SimFault::gps_off};

const char* name_of(SimFault fault);
constexpr bool decides(SimFault fault) { return fault != SimFault::killed && fault != SimFault::loop_hangs; }
constexpr bool commands(SimFault fault) { return fault != SimFault::killed && fault != SimFault::bus_cut; }

/// Takes from a tick's input what a fault keeps from the robot.
class FaultInjector {
 public:
  FaultInjector(const Dbc& dbc, const CanRolesParams& roles) : decoder_(dbc, roles) {}

  /// Call once for each tick, from the tick on in which the fault begins; always with the same fault.
  void inject(SimFault fault, TickInput& input);

 private:
  VehicleDecoder decoder_;  ///< tells which messages bring the encoders
  std::optional<SampleFaults> silence_;
};

}  // namespace hindsight::tools
