// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A robot that drives itself in a simulated world, in lock step: vehicle and reflex at 100 Hz, camera and
// core at the loop's rate. The same world, seed and configuration give the same run, bit for bit.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "daemon/outbox.h"
#include "daemon/robot.h"
#include "daemon/virtual_reflex.h"
#include "sim_replay/run_header.h"
#include "sim_replay/run_log_writer.h"
#include "tools/sim_fault.h"
#include "tools/sim_feed.h"

namespace hindsight::tools {

struct SimSummary {
  int ticks = 0;
  double seconds = 0.0;     ///< of the world's time
  double to_goal_m = 0.0;   ///< true distance, whatever the robot believes
  double drift_m = 0.0;     ///< between where it is and where it believes to be
  double distance_m = 0.0;  ///< driven
  int touches = 0;          ///< times that a bumper closed
  int ir_touches = 0;       ///< times that only an infrared sensor met something
  int lessons = 0;          ///< training events that changed the mixture
  Behaviour behaviour = Behaviour::idle;
  bool reached = false;  ///< the robot says so; in mode road: it truly came to the road's end
};

struct SimSetup {
  Configuration configuration;
  World world;
  std::uint64_t seed = 1;             ///< of the noise of camera, sensors and ground
  std::vector<std::uint8_t> mixture;  ///< as saved by a run; empty: the first frame makes one
  /// Changes each tick before the core sees it: faults, an operator's orders.
  std::function<void(TickInput&)> disturb = {};
};

/// What a log of a simulated run begins with: DBC and calibration are the built-in ones.
RunHeader sim_materials(const Configuration& configuration, const std::vector<std::uint8_t>& mixture);

/// The robot's own world W begins where it stands, its x axis straight ahead.
Point2 in_robots_world(const World& world, WorldPoint p);

class SimRun {
 public:
  explicit SimRun(const SimSetup& setup);

  /// One tick: the world moves on for a period, then the core steps. What the tick decides drives the wheels
  /// from the vehicle's next period on. `fault`: of this tick; `watch` sees each period of the vehicle with
  /// the command that it leads to.
  using Watch =
      std::function<void(Time now, const SimVehicle& vehicle, const std::optional<WheelCommand>& command)>;
  void step(SimFault fault = SimFault::none, const Watch& watch = {});
  /// Writes the tick just run to a log that begins with materials().
  void record(RunLogWriter& log) const;

  const RunHeader& materials() const { return materials_; }
  const TickInput& input() const { return input_; }
  const Outbox& outbox() const { return outbox_; }
  const Decision& decision() const { return decision_; }
  const Robot& robot() const { return robot_; }
  const SimFeed& feed() const { return feed_; }
  SimSummary summary() const;

 private:
  void give_orders();

  RunHeader materials_;
  RobotSetup setup_;
  SimFeed feed_;
  VirtualReflex reflex_;
  Robot robot_;
  FaultInjector injector_;
  std::function<void(TickInput&)> disturb_;
  TickInput input_;
  Outbox outbox_;
  Decision decision_;
  int lessons_ = 0;
};

}  // namespace hindsight::tools
