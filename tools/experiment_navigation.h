// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Thesis 5.2.2, autonomous navigation: does reverse optical flow make the robot drive better?
#pragma once

#include <string>

namespace hindsight::tools {

struct NavigationExperiment {
  std::string course;
  std::string folder;  ///< where run_segmentation_experiment left its mixtures, too
  /// Whose: "default", "color" or "thesis", as in segmentation_arms().
  std::string numbers = "default";
  int worlds = 4;             ///< course seeds
  int starts = 5;             ///< in each world
  unsigned first_seed = 101;  ///< other trees than those of the training drives
  double seconds = 600.0;     ///< longest run
  int processes = 2;
};

/// Learning off; each arm drives from the same starts among the same trees with the mixture of its training
/// drive. Appends each run to navigation_runs.jsonl and skips those that are there already; writes
/// navigation.json, .md, _paths.png (figure 5.12) and _ellipses.png (figure 5.13), with the name of the
/// numbers after "navigation" where they are not the default's. Returns an exit code.
int run_navigation_experiment(const NavigationExperiment& experiment);

}  // namespace hindsight::tools
