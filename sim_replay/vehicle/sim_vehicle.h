// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A LAGR-style vehicle in a world: a differential drive that moves as its ground lets it, and says what such
// a base says of itself. Runs in the samples' time, one period a call; no clock, no thread. The same world,
// seed and commands give the same samples, bit for bit.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "config/vehicle_params.h"
#include "drivers/samples.h"
#include "drivers/tick_input.h"
#include "drivers/vehicle_base_codec.h"
#include "sim_replay/vehicle/chassis.h"
#include "sim_replay/vehicle/gps_receiver.h"
#include "sim_replay/vehicle/motor_current.h"
#include "sim_replay/vehicle/suspension.h"
#include "sim_replay/vehicle/touch_count.h"
#include "sim_replay/vehicle/wheel_encoder.h"
#include "sim_replay/world/obstacle.h"
#include "sim_replay/world/random.h"
#include "sim_replay/world/world.h"

namespace hindsight {

/// Set-points of the wheels' contact points, forward positive.
struct WheelCommand {
  double left_mps = 0.0;
  double right_mps = 0.0;
};

class SimVehicle {
 public:
  /// One step of its motion, and the fastest report.
  static constexpr Time kPeriod{10'000'000};
  /// The base stops its wheels when no command has come for so long (lagr.dbc).
  static constexpr Time kCommandTimeout{100'000'000};

  /// Stands at the world's start. FatalError as VehicleBaseCodec; `dbc` is used here only. `ir_touch_m`: an
  /// IR range below it is a touch (ir_touches()).
  SimVehicle(const VehicleParams& params, const World& world, const Dbc& dbc, const CanRolesParams& roles,
             double ir_touch_m, std::uint64_t seed);

  /// The levels that lines report at start.
  void report_lines(Time now, std::vector<LineEdge>& edges) const;
  /// One period up to `now`; `command`: what came from the bus in it, or nothing. Appends the CAN frames,
  /// line edges and GPS fixes of the period, stamped `now`.
  void step(Time now, const std::optional<WheelCommand>& command, TickInput& samples);

  const BodyPose& pose() const { return X_WB_; }
  double speed_mps() const { return chassis_.speed_mps(); }
  double yaw_rate_radps() const { return chassis_.yaw_rate_radps(); }
  /// Driven since start, backwards too.
  double distance_m() const { return chassis_.distance_m(); }
  /// Times that a bumper closed.
  int touches() const { return touches_.bumper(); }
  /// Times that an IR range fell below the threshold and no bumper closed before it rose again.
  int ir_touches() const { return touches_.ir(); }
  /// Truth: a driven wheel turns faster over the ground than it should, by more than 0.3 of its speed.
  bool slipping() const { return slipping_[0] || slipping_[1]; }
  /// The body itself, not only its bumper, rests against something rigid.
  bool collided() const { return chassis_.collided(); }
  /// Beyond the ground that is drawn.
  bool left_world() const;

 private:
  void obey(Time now, const std::optional<WheelCommand>& command);
  void look_around();
  void feel_bumper(Time now, std::vector<LineEdge>& edges);
  void feel_slip();
  void report_wheels(Time now, std::vector<CanFrame>& frames);
  void report_ir(Time now, std::vector<CanFrame>& frames);
  void report_imu(Time now, std::vector<CanFrame>& frames);
  void report_battery(Time now, std::vector<CanFrame>& frames);
  void report_position(Time now, std::vector<GpsFix>& fixes);
  double leaves_overhead() const;

  VehicleParams params_;
  World world_;
  VehicleBaseCodec codec_;
  std::vector<Obstacle> obstacles_;
  std::vector<Obstacle> nearby_;  ///< of them, what the vehicle may touch or see before it looks around again
  WorldPoint looked_around_at_;
  Chassis chassis_;
  Suspension suspension_;
  std::array<WheelEncoder, 2> encoders_;
  std::array<MotorCurrent, 2> currents_;
  GpsReceiver gps_;
  TouchCount touches_;
  Random noise_;
  double gyro_bias_radps_;
  double battery_v_;
  BodyPose X_WB_;
  WheelCommand told_;
  std::optional<Time> told_at_;
  std::array<bool, 2> bumper_{};
  std::array<bool, 2> slipping_{};
  std::uint64_t steps_ = 0;
  VehicleSignals signals_;
};

}  // namespace hindsight
