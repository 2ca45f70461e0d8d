// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A simulated vehicle at the other end of a live robot's devices: the camera sees the world through
// v4l2loopback, the base answers on the CAN bus, gpio-sim lines are pulled, gpsd's port tells fixes. Goes by
// the machine's clock.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "daemon/robot_config.h"
#include "sim_replay/world/world.h"

namespace hindsight::tools {

struct DevicesSummary {
  double seconds = 0.0;    ///< since start
  double to_goal_m = 0.0;  ///< true distance
  double distance_m = 0.0;
  int touches = 0;
  int ir_touches = 0;
  std::uint64_t commands = 0;  ///< good ones that came over the bus
  std::uint64_t frames = 0;    ///< shown to the camera
};

struct DevicesRun {
  Configuration configuration;  ///< the robot's own: names devices, protocol and calibration
  World world;
  std::uint64_t seed = 1;
  double seconds = 0.0;  ///< to run
};

/// Runs until run.seconds have passed or `stop` is set; tells how it stands once a second, and at the end.
/// The camera has a thread of its own, so that pictures that take long to draw do not hold up the base.
/// FatalError where a device is absent (69) or fails (74).
DevicesSummary run_on_devices(const DevicesRun& run, const std::atomic<bool>& stop,
                              const std::function<void(const DevicesSummary&)>& tell);

}  // namespace hindsight::tools
