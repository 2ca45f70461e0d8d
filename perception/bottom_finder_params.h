// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "config/params.h"

namespace hindsight {

struct BottomFinderParams {
  double max_range_m = 25.0;
  int strip_px = 2;
  double step_m = 0.1;
  int min_run_px = 3;
  double min_height_m = 0.3;
  int ground_resumes_px = 12;
  std::string weighting = "area";
  std::string unknown = "nothing";
  double sure_range_m = 8.0;
  double max_obstacle_m = 1.0;

  void visit(auto&& param) {
    param("max_range_m", max_range_m, Range{2.0, 200.0}, "farthest ground that votes [m]");
    param("strip_px", strip_px, Range{1, 8},
          "columns judged together [px]; 1: every column alone, the thesis");
    param("step_m", step_m, Range{0.02, 1.0},
          "length of ground judged together, and spacing of votes in depth [m]");
    param("min_run_px", min_run_px, Range{1, 50},
          "obstacle pixels above one another that make an obstacle [px]");
    param("min_height_m", min_height_m, Range{0.0, 10.0},
          "what is called lethal but looks lower than this lies flat and is none [m]; 0: anything counts, "
          "the thesis");
    param("ground_resumes_px", ground_resumes_px, Range{0, 500},
          "good pixels above one another that end an obstacle: ground is seen again behind it [px]; 0: "
          "never, the thesis");
    param("weighting", weighting, Choices{"area", "pixels"},
          "what a pixel's vote weighs; pixels: the thesis");
    param("unknown", unknown, Choices{"nothing", "good", "bad"}, "what unknown pixels count as");
    param("sure_range_m", sure_range_m, Range{0.5, 200.0},
          "area votes from beyond weigh less, as 1 / range [m]");
    param("max_obstacle_m", max_obstacle_m, Range{0.1, 100.0},
          "height up to which an obstacle's area votes [m]");
  }
};

}  // namespace hindsight
