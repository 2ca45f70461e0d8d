// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Are rendered colours those of the real outdoors? Histograms by class, of labelled stills and of rendered
// frames, side by side.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hindsight::tools {

struct ColoursExperiment {
  std::vector<std::string> courses;
  std::string stills;  ///< folder of folders with rgb.jpg and labels.png, in the colours of YCOR
  std::string folder;  ///< for results
  int frames = 40;     ///< rendered of each course
  std::uint64_t seed = 1;
};

/// Writes colours.json, colours.md and colours.png. Returns an exit code.
int run_colours_experiment(const ColoursExperiment& experiment);

}  // namespace hindsight::tools
