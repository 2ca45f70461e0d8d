// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A differential drive among trees: moves as its wheels are told, stops at trunks, and says what a LAGR-style
// base says of itself. Runs in the samples' time, one period a call.
#pragma once

#include <array>
#include <vector>

#include "config/vehicle_params.h"
#include "drivers/samples.h"
#include "drivers/tick_input.h"
#include "drivers/vehicle_base_codec.h"
#include "sim_replay/demo_random.h"
#include "sim_replay/demo_scene.h"

namespace hindsight {

class DemoVehicle {
 public:
  /// One step of its motion.
  static constexpr Time kPeriod{10'000'000};

  /// FatalError as VehicleBaseCodec; `dbc` is used here only.
  DemoVehicle(const VehicleParams& params, const DemoWorld& world, const Dbc& dbc,
              const CanRolesParams& roles, std::uint64_t seed);

  /// The levels that lines report at start.
  void report_lines(Time now, std::vector<LineEdge>& edges) const;
  /// One period up to `now`, with the wheels told to run at these speeds; appends what the base sends
  /// meanwhile.
  void step(Time now, double left_mps, double right_mps, TickInput& samples);

  const DemoPose& pose() const { return X_WB_; }
  /// Times that a bumper closed.
  int touches() const { return touches_; }

 private:
  struct Wheel {
    double speed_mps = 0.0;
    double acceleration_mps2 = 0.0;
    double way_m = 0.0;  ///< driven, for the tick counter
  };

  void turn_wheel(Wheel& wheel, double wanted_mps) const;
  void move();
  double penetration_m(const DemoPose& X_WB) const;
  void feel_bumper(Time now, std::vector<LineEdge>& edges);
  void set_bumper(bool left, bool pressed, Time now, std::vector<LineEdge>& edges);
  void report(Time now, std::vector<CanFrame>& frames);
  double current_a(const Wheel& wheel, Time now);
  double ir_range_m(double side_m);

  VehicleParams params_;
  DemoWorld world_;
  VehicleBaseCodec codec_;
  DemoRandom random_;
  DemoPose X_WB_;
  double yaw_rate_radps_ = 0.0;
  bool in_mud_ = false;
  Wheel left_;
  Wheel right_;
  std::array<bool, 2> bumper_{};
  int touches_ = 0;
  int steps_ = 0;
  VehicleSignals signals_;
};

}  // namespace hindsight
