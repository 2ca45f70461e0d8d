// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The only way to the motors. Pure: what goes in, and what may come out at this instant. Zero needs no permission and
// comes at once; everything else must be finite, fresh, permitted, within the wheels' speed and acceleration.
#pragma once

#include "config/params.h"
#include "config/vehicle_params.h"
#include "daemon/stop_reason.h"
#include "drivers/samples.h"
#include "planning/drive_command.h"

namespace hindsight {

struct GateParams {
  double command_timeout_s = 0.25;

  void visit(auto&& param) {
    param("command_timeout_s", command_timeout_s, Range{0.02, 2.0},
          "a set-point older than this stops the vehicle [s]");
  }
};

struct GateInput {
  Time now{};
  DriveCommand wanted;                         ///< the loop's latest set-point
  Time decided_at{};                           ///< `now` of the tick that decided it
  StopReason loop_reason = StopReason::not_armed;  ///< the loop's own verdict
  bool estop_active = false;
  bool bumper_active = false;   ///< either bumper is pressed now
  Time last_bumper_edge{};      ///< when one was last pressed; the loop must have decided after it
  Time last_estop_edge{};       ///< the same of the e-stop: it may be over before the loop has latched it
  bool lines_ok = false;        ///< GPIO lines can be read
  bool bus_ok = false;          ///< the CAN bus takes frames
};

struct GateOutput {
  DriveCommand command;
  StopReason reason = StopReason::not_armed;
};

class CommandGate {
 public:
  CommandGate(const GateParams& params, const VehicleParams& vehicle);
  GateOutput step(const GateInput& input);

 private:
  StopReason verdict(const GateInput& input) const;
  double limited(double wanted_mps, double last_mps, double dt_s) const;

  GateParams params_;
  VehicleParams vehicle_;
  DriveCommand last_;
  Time last_time_{};
};

}  // namespace hindsight
