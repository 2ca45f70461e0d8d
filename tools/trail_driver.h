// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>

#include "sim_replay/vehicle/sim_vehicle.h"
#include "sim_replay/world/world.h"

namespace hindsight::tools {

/// A person at the wheel on a trail: follows its middle to the end, swaying a little to both sides as people
/// do.
class TrailDriver {
 public:
  static constexpr double kSpeed_mps = 0.95;
  static constexpr double kSway_m = 0.3;
  static constexpr double kSwayPeriod_m = 37.0;

  /// FatalError(kExitBadData) where the world has no trail. The world must outlive the driver.
  TrailDriver(const World& world, double track_width_m);

  /// What the wheels are to be told now: pure pursuit of a point of the trail ahead.
  WheelCommand drive(const SimVehicle& vehicle);
  /// The trail's part between start and goal has been driven.
  bool arrived(const SimVehicle& vehicle) const;

 private:
  void find_nearest(WorldPoint at);
  WorldPoint target(double driven_m) const;

  const Trail& trail_;
  WorldPoint goal_;
  double half_track_m_;
  std::size_t nearest_ = 0;
};

}  // namespace hindsight::tools
