// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The whole configuration: every parameter struct of the system under its section's name. A parameter is declared
// beside its algorithm; here is only the list.
#pragma once

#include <string>

#include "config/vehicle_params.h"
#include "daemon/command_gate.h"
#include "daemon/command_receiver.h"
#include "daemon/failsafe.h"
#include "daemon/flight_recorder.h"
#include "daemon/reflex.h"
#include "drivers/can_roles.h"
#include "drivers/gpio_lines.h"
#include "drivers/gpsd_client.h"
#include "drivers/socketcan_bus.h"
#include "drivers/v4l2_camera.h"
#include "perception/activity_map.h"
#include "perception/appearance_history.h"
#include "perception/bottom_finder.h"
#include "perception/evidence_grid.h"
#include "perception/flow_history.h"
#include "perception/ground_odometry.h"
#include "perception/ground_slip.h"
#include "perception/localisation_params.h"
#include "perception/motion_tracker.h"
#include "perception/optical_flow_params.h"
#include "perception/road_params.h"
#include "perception/slip_detector.h"
#include "perception/terrain_labeller.h"
#include "perception/terrain_mixture.h"
#include "perception/training_events.h"
#include "perception/training_patch.h"
#include "planning/navigator.h"

namespace hindsight {

struct RobotParams {
  std::string mode = "drive";
  std::string calibration = "camera.yaml";
  bool learning = true;
  std::string model_file;
  std::string state_file;
  double loop_rate_hz = 10.0;
  int loop_priority = 20;
  int loop_cpu = -1;
  bool lock_memory = true;
  double current_rate_hz = 20.0;
  double watchdog_s = 1.0;

  void visit(auto&& param) {
    param("mode", mode, Choices{"watch", "drive", "road"},
          "watch: see and learn, never drive; drive: go to the goal; road: follow the road, to the goal if there is one");
    param("calibration", calibration, AnyText{}, "camera calibration in OpenCV's YAML, relative to this file");
    param("learning", learning, YesNo{}, "train the mixture; off: it stays as loaded");
    param("model_file", model_file, AnyText{}, "where the learned mixture outlives the process; empty: nowhere");
    param("state_file", state_file, AnyText{},
          "where gyro bias and last trajectory outlive the process; empty: nowhere");
    param("loop_rate_hz", loop_rate_hz, Range{1.0, 100.0}, "ticks a second; best the camera's rate [Hz]");
    param("loop_priority", loop_priority, Range{0, 99}, "SCHED_FIFO priority of the loop; 0: none");
    param("loop_cpu", loop_cpu, Range{-1, 1023}, "processor that the loop stays on; -1: any");
    param("lock_memory", lock_memory, YesNo{}, "keep the process in memory: nothing of it is ever swapped out");
    param("current_rate_hz", current_rate_hz, Range{7.0, 1000.0}, "how often the base tells motor currents [Hz]");
    param("watchdog_s", watchdog_s, Range{0.1, 60.0},
          "a thread silent for so long hangs: the vehicle is stopped and the process ends [s]");
  }
};

struct TelemetryParams {
  std::string lcm_url = "udpm://239.255.76.67:7667?ttl=0";
  int grid_every_ticks = 5;
  int grid_cells = 200;
  double preview_hz = 0.0;
  int preview_quality = 60;

  void visit(auto&& param) {
    param("lcm_url", lcm_url, AnyText{}, "where telemetry is published; empty: nowhere");
    param("grid_every_ticks", grid_every_ticks, Range{1, 1000}, "how often the evidence grid is published [ticks]");
    param("grid_cells", grid_cells, Range{10, 400}, "side of the published part of the grid [cells]");
    param("preview_hz", preview_hz, Range{0.0, 30.0}, "camera previews a second; 0: none [Hz]");
    param("preview_quality", preview_quality, Range{10, 95}, "JPEG quality of previews");
  }
};

struct RecorderParams {
  int queue_ticks = 20;

  void visit(auto&& param) {
    param("queue_ticks", queue_ticks, Range{2, 100}, "ticks that may wait for the disk before the log loses one");
  }
};

struct Configuration {
  RobotParams robot;
  VehicleParams vehicle;
  CameraParams camera;
  CanBusParams can;
  CanRolesParams can_roles;
  GpioParams gpio;
  GpsParams gps;
  CommandParams command;
  TelemetryParams telemetry;
  RecorderParams recorder;
  FlightRecorderParams flight_recorder;
  FailsafeParams failsafe;
  GateParams gate;
  ReflexParams reflex;
  LocalisationParams localisation;
  OpticalFlowParams flow;
  FlowHistoryParams flow_history;
  AppearanceHistoryParams appearance;
  MixtureParams mixture;
  TrainingEventParams training;
  TrainingPatchParams reverse_flow;
  LabelParams labels;
  BottomFinderParams bottom_finder;
  EvidenceGridParams evidence_grid;
  SlipDetectorParams slip;
  GroundSlipParams ground_slip;
  GroundOdometryParams ground_odometry;
  MotionParams motion;
  ActivityMapParams activity_map;
  RoadParams road;
  PlanningParams planning;

  void visit(auto&& section) {
    section("robot", robot);
    section("vehicle", vehicle);
    section("camera", camera);
    section("can", can);
    section("can.roles", can_roles);
    section("gpio", gpio);
    section("gps", gps);
    section("command", command);
    section("telemetry", telemetry);
    section("recorder", recorder);
    section("flight_recorder", flight_recorder);
    section("failsafe", failsafe);
    section("gate", gate);
    section("reflex", reflex);
    section("localisation", localisation);
    section("flow", flow);
    section("flow_history", flow_history);
    section("appearance", appearance);
    section("mixture", mixture);
    section("training", training);
    section("reverse_flow", reverse_flow);
    section("labels", labels);
    section("bottom_finder", bottom_finder);
    section("evidence_grid", evidence_grid);
    section("slip", slip);
    section("ground_slip", ground_slip);
    section("ground_odometry", ground_odometry);
    section("motion", motion);
    section("activity_map", activity_map);
    section("road", road);
    section("cost_map", planning.cost_map);
    section("rollouts", planning.rollouts);
    section("behaviours", planning.behaviours);
  }
};

}  // namespace hindsight
