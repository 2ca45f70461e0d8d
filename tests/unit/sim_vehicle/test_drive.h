// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <vector>

#include "drivers/vehicle_decoder.h"
#include "sim_replay/vehicle/sim_vehicle.h"

namespace hindsight {

inline World flat_world(Ground ground) {
  World world;
  world.ground = ground;
  world.goal = {100.0, 0.0};
  world.half_size_m = 1000.0;
  return world;
}

/// A vehicle that is driven by hand, and all that it said.
class TestDrive {
 public:
  static constexpr double kIrTouch_m = 0.6;

  explicit TestDrive(const World& world, std::uint64_t seed = 1)
      : vehicle(VehicleParams{}, world, dbc_, {}, kIrTouch_m, seed) {}

  void step(const std::optional<WheelCommand>& command) {
    now += SimVehicle::kPeriod;
    heard.clear();
    vehicle.step(now, command, heard);
    for (const CanFrame& frame : heard.can) decoder.decode(frame);
    edges.insert(edges.end(), heard.edges.begin(), heard.edges.end());
  }
  void drive(double left_mps, double right_mps, double seconds) {
    const Time until = now + from_seconds(seconds);
    while (now < until) step(WheelCommand{left_mps, right_mps});
  }
  const VehicleSignals& signals() const { return decoder.signals(); }

 private:
  const Dbc dbc_ = read_dbc(HINDSIGHT_SOURCE_DIR "/config/lagr.dbc");

 public:
  SimVehicle vehicle;
  VehicleDecoder decoder{dbc_, {}};
  Time now = from_seconds(1.0);
  TickInput heard;  ///< in the last step
  std::vector<LineEdge> edges;
};

}  // namespace hindsight
