// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// How far a vehicle still rolls when its process is killed or its sensors die one by one.
#pragma once

#include <string>

namespace hindsight::tools {

struct FailsafeExperiment {
  std::string course;
  std::string folder;
  int drives = 3;           ///< for each fault, each in a world of its own
  double cruise_mps = 0.9;  ///< the fault comes once it has been so fast for a second
  double longest_s = 60.0;  ///< by when it must have been
  unsigned seed = 1;        ///< of the first drive; the others follow
};

/// Drives and writes failsafe.json, .md, .png. Returns an exit code. FatalError where the robot does not get
/// to cruise.
int run_failsafe_experiment(const FailsafeExperiment& experiment);

}  // namespace hindsight::tools
