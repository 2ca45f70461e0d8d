// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// How far tracebacks through reverse optical flow end from where things truly were (thesis 2.3, 6.1).
#pragma once

#include <string>

namespace hindsight::tools {

struct TracebackExperiment {
  std::string course;
  std::string folder;
  int frames = 600;  ///< of each drive, one a light
  int every =
      10;  ///< of so many frames, one is traced back from; the numbers of frames back are multiples of it
  unsigned seed = 1;  ///< of the world
};

/// Drives and writes traceback.json, .md, .png. Returns an exit code.
int run_traceback_experiment(const TracebackExperiment& experiment);

}  // namespace hindsight::tools
