// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/slip_drive.h"

#include "drivers/dbc.h"
#include "drivers/vehicle_decoder.h"
#include "sim_replay/vehicle/sim_vehicle.h"
#include "sim_replay/world/random.h"
#include "tools/builtin_config.h"
#include "tools/guide.h"

namespace hindsight::tools {
namespace {

constexpr Time kStart = from_seconds(1.0);
constexpr std::uint64_t kPaceStream = 77;
constexpr double kSlowest = 0.7, kFastest = 1.2;
constexpr Time kStuckAfter = from_seconds(4.0);
constexpr Time kBackOut = from_seconds(5.0);
constexpr double kBackOut_mps = 0.6;

/// The guide, who also knows when to give up.
class Driver {
 public:
  Driver(const World& world, double track_width_m, std::uint64_t seed)
      : guide_(world, track_width_m, 0), pace_(Random(seed, kPaceStream).uniform(kSlowest, kFastest)) {}

  WheelCommand drive(const SimVehicle& vehicle, Time now) {
    if (!vehicle.slipping() || now < back_until_) gripped_at_ = now;
    if (now - gripped_at_ > kStuckAfter) back_until_ = now + kBackOut;
    if (now < back_until_) return {-kBackOut_mps, -kBackOut_mps};
    const WheelCommand command = guide_.drive(vehicle, now);
    return {pace_ * command.left_mps, pace_ * command.right_mps};
  }

 private:
  Guide guide_;
  double pace_;
  Time gripped_at_{};
  Time back_until_{};
};

}  // namespace

SlipTrace drive_for_slip(const Configuration& configuration, const World& world, std::uint64_t seed,
                         double seconds) {
  const Dbc dbc = parse_dbc(builtin_dbc(), "lagr.dbc");
  SimVehicle vehicle(configuration.vehicle, world, dbc, configuration.can_roles,
                     configuration.training.ir_threshold_m, seed);
  VehicleDecoder decoder(dbc, configuration.can_roles);
  Driver driver(world, configuration.vehicle.track_width_m, seed);
  const Time tick = from_seconds(1.0 / configuration.robot.loop_rate_hz);
  SlipTrace trace{.begin = kStart};
  TickInput heard;
  WheelCommand command;
  Time next = kStart + tick;
  for (Time now = kStart + SimVehicle::kPeriod; to_seconds(now - kStart) < seconds;
       now += SimVehicle::kPeriod) {
    heard.clear();
    vehicle.step(now, command, heard);
    trace.see_truth(now, vehicle.slipping());
    for (const CanFrame& frame : heard.can) {
      const SignalGroups groups = decoder.decode(frame);
      const VehicleSignals& told = decoder.signals();
      if (groups.has(SignalGroup::wheels))
        trace.speeds.push_back({told.wheels_stamp, told.left_mps, told.right_mps});
      if (groups.has(SignalGroup::currents))
        trace.currents.push_back({told.currents_stamp, told.left_a, told.right_a});
    }
    if (now < next) continue;
    next += tick;
    const VehicleSignals& signals = decoder.signals();
    trace.ticks.push_back({now,
                           {{{command.left_mps, signals.left_mps}, {command.right_mps, signals.right_mps}}},
                           vehicle.pose()});
    command = driver.drive(vehicle, now);
  }
  return trace;
}

}  // namespace hindsight::tools
