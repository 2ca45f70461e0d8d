// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

#include "config/params.h"

namespace hindsight {

/// Which signal of the DBC file plays which role, as "MESSAGE.SIGNAL". An empty string says that the vehicle
/// has no such signal; the wheels' speeds and the command's set-points must be there. Units are checked
/// against the DBC file's.
struct CanRolesParams {
  std::string dbc = "lagr.dbc";
  std::string counter = "COUNTER";
  std::string checksum = "CHECKSUM";
  std::string left_speed = "WHEEL_ENCODERS.LEFT_SPEED";
  std::string right_speed = "WHEEL_ENCODERS.RIGHT_SPEED";
  std::string left_ticks = "WHEEL_ENCODERS.LEFT_TICKS";
  std::string right_ticks = "WHEEL_ENCODERS.RIGHT_TICKS";
  std::string left_current = "MOTOR_CURRENTS.LEFT_CURRENT";
  std::string right_current = "MOTOR_CURRENTS.RIGHT_CURRENT";
  std::string left_range = "IR_RANGES.LEFT_RANGE";
  std::string right_range = "IR_RANGES.RIGHT_RANGE";
  std::string battery_voltage = "BATTERY.VOLTAGE";
  std::string yaw_rate = "IMU.YAW_RATE";
  std::string command_left_speed = "DRIVE_COMMAND.LEFT_SPEED";
  std::string command_right_speed = "DRIVE_COMMAND.RIGHT_SPEED";
  std::string command_enable = "DRIVE_COMMAND.ENABLE";

  void visit(auto&& param) {
    param("dbc", dbc, AnyText{}, "DBC file with the CAN protocol, relative to the configuration file");
    param("counter", counter, AnyText{}, "name of the counter signal that each message carries");
    param("checksum", checksum, AnyText{}, "name of the checksum signal that each message carries");
    param("left_speed", left_speed, AnyText{}, "left wheel's speed over ground [m/s]");
    param("right_speed", right_speed, AnyText{}, "right wheel's speed over ground [m/s]");
    param("left_ticks", left_ticks, AnyText{}, "left encoder's cumulative count, or empty");
    param("right_ticks", right_ticks, AnyText{}, "right encoder's cumulative count, or empty");
    param("left_current", left_current, AnyText{}, "left motor's current [A], or empty");
    param("right_current", right_current, AnyText{}, "right motor's current [A], or empty");
    param("left_range", left_range, AnyText{}, "left infrared range [m], or empty");
    param("right_range", right_range, AnyText{}, "right infrared range [m], or empty");
    param("battery_voltage", battery_voltage, AnyText{}, "battery voltage [V], or empty");
    param("yaw_rate", yaw_rate, AnyText{}, "yaw rate, counter-clockwise from above [rad/s], or empty");
    param("command_left_speed", command_left_speed, AnyText{}, "left wheel's set-point [m/s]");
    param("command_right_speed", command_right_speed, AnyText{}, "right wheel's set-point [m/s]");
    param("command_enable", command_enable, AnyText{}, "1 lets the motors run, or empty");
  }
};

}  // namespace hindsight
