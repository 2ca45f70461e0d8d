// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

namespace hindsight::tools {

/// One row of a recording of a vehicle with a motor on each side.
struct MotorSample {
  double left_a = 0.0;
  double right_a = 0.0;
  double left_mps = 0.0;
  double right_mps = 0.0;
};

struct MotorRecording {
  std::vector<MotorSample> samples;
  bool has_speeds = false;  ///< otherwise they are 0
};

/// Reads a CSV file with one line of column names. Columns are found by name, in upper or lower case: "cur"
/// for a current, "vel" or "speed" for a speed, and "left" or a final l, "right" or a final r for the side
/// (curL, velR, current_left); or as `columns` names them: left and right current and, if the file has them,
/// left and right speed. FatalError: kExitNoInput for a file that cannot be read, kExitBadData naming
/// FILE:LINE for a column that is missing and a field that is not a finite number.
MotorRecording read_motor_csv(const std::string& path, const std::vector<std::string>& columns);

}  // namespace hindsight::tools
