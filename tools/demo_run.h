// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A robot in a small synthetic grove, in lock step: vehicle and reflex at 100 Hz, camera and core at the
// loop's rate. No clock and no thread: the same seed gives the same run, bit for bit.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "daemon/outbox.h"
#include "daemon/robot.h"
#include "daemon/virtual_reflex.h"
#include "drivers/frame_pool.h"
#include "sim_replay/demo_scene.h"
#include "sim_replay/demo_vehicle.h"
#include "sim_replay/run_header.h"
#include "sim_replay/run_log_writer.h"

namespace hindsight::tools {

struct DemoSummary {
  int ticks = 0;
  double seconds = 0.0;
  double to_goal_m = 0.0;  ///< true distance, whatever the robot believes
  double drift_m = 0.0;    ///< between where it is and where it believes to be
  int touches = 0;
  int components_learnt = 0;
  Behaviour behaviour = Behaviour::idle;
  bool reached = false;  ///< the robot says so
};

class DemoRun {
 public:
  /// `configuration`: of the robot; DBC and calibration are the built-in ones.
  DemoRun(const Configuration& configuration, std::uint64_t seed);

  /// One tick: the world moves on for a period, then the core steps.
  void step();

  /// Writes the tick just run to a log that begins with materials().
  void record(RunLogWriter& log) const;

  const RunHeader& materials() const { return materials_; }
  const TickInput& input() const { return input_; }
  const Outbox& outbox() const { return outbox_; }
  const Robot& robot() const { return robot_; }
  const DemoWorld& world() const { return world_; }
  const DemoPose& true_pose() const { return vehicle_.pose(); }
  DemoSummary summary() const;

 private:
  void let_the_world_move();
  void take_picture();
  void give_orders();

  RunHeader materials_;
  RobotSetup setup_;
  DemoWorld world_;
  DemoScene scene_;
  DemoVehicle vehicle_;
  VirtualReflex reflex_;
  Robot robot_;
  FramePool pool_;
  TickInput input_;
  TickInput moment_;  ///< what happened within the vehicle's last period
  Outbox outbox_;
  Time period_;
  bool began_ = false;
  int components_learnt_ = 0;
};

}  // namespace hindsight::tools
