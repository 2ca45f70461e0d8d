// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// How soon wheel slip is told, and how often it is told where there is none.
#pragma once

#include <string>
#include <vector>

namespace hindsight::tools {

struct SlipExperiment {
  std::string course;  ///< with mud
  std::string folder;
  int slips = 400;          ///< so many at least
  double hours = 5.0;       ///< on the same course without mud, over all kinds of ordinary ground
  double seen_hours = 0.5;  ///< rendered beside them, to know how well the camera measures
  unsigned seed = 1;        ///< of the first drive; the others follow
  std::vector<std::string>
      recordings;  ///< CSV files of motor currents where nothing is known to slip; may be none
  double recordings_hz = 15.0;
};

/// Drives and writes slip.json, .md, .png. Slips are rendered, and seen_hours of ordinary ground; the hours
/// beside them are fed with the true motion and the errors measured there. Returns an exit code. FatalError
/// where the course's mud makes no slips.
int run_slip_experiment(const SlipExperiment& experiment);

}  // namespace hindsight::tools
