// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "config/params.h"

namespace hindsight {

/// Which corners are tracked (thesis 2.1). The thesis: kernel 11, sigma 2.15, quality 0.05, spacing 1, no
/// quota. A low threshold with a quota was measured better than 0.05, with which one strong corner starves
/// the rest: upper quartile of the traceback error 5.8 px instead of 9.0 (quality 0.003, no quota) on a road.
struct CornerParams {
  int smoothing_kernel_px = 5;
  double smoothing_sigma_px = 1.0;
  double quality = 0.0003;
  int max_features = 2000;
  double min_spacing_px = 5.0;
  int quota_columns = 24;
  int quota_rows = 16;
  int quota_per_cell = 6;

  void visit(auto&& param) {
    param("smoothing_kernel_px", smoothing_kernel_px, Range{1, 15},
          "side of the Gaussian kernel, odd; 1: none [px]");
    param("smoothing_sigma_px", smoothing_sigma_px, Range{0.1, 5.0}, "its standard deviation [px]");
    param("quality", quality, Range{0.0, 1.0},
          "weakest corner kept, in parts of the strongest minimum eigenvalue");
    param("max_features", max_features, Range{1, 20000}, "corners kept, the strongest first");
    param("min_spacing_px", min_spacing_px, Range{0.0, 100.0}, "no two corners are nearer [px]");
    param("quota_columns", quota_columns, Range{1, 128}, "cells across the image, for the quota");
    param("quota_rows", quota_rows, Range{1, 128}, "cells down the image, for the quota");
    param("quota_per_cell", quota_per_cell, Range{0, 20000}, "corners kept in one cell; 0: no limit");
  }
};

/// How they are followed into the frame before (thesis 2.2). The thesis: 5 levels, sigma 1.25, window 3, mean
/// not removed, no forward-backward check (forward_backward_px = 0).
struct TrackerParams {
  int pyramid_levels = 5;
  double prefilter_sigma_px = 1.25;
  int window_px = 7;
  int max_iterations = 4;
  double stop_step_px = 0.06;
  double max_move_px = 6.0;
  double min_gradient = 0.5;
  bool remove_mean = true;
  double forward_backward_px = 0.5;
  int check_levels = 2;

  void visit(auto&& param) {
    param("pyramid_levels", pyramid_levels, Range{1, 8},
          "levels of the image pyramid, each half the one above");
    param("prefilter_sigma_px", prefilter_sigma_px, Range{0.5, 3.0},
          "5 x 5 Gaussian before each halving [px]");
    param("window_px", window_px, Range{3, 13}, "side of the tracking window, odd [px]");
    param("max_iterations", max_iterations, Range{1, 50}, "steps on each level");
    param("stop_step_px", stop_step_px, Range{0.001, 1.0}, "a step shorter than this is the last [px]");
    param("max_move_px", max_move_px, Range{0.5, 1000.0},
          "a corner that moves further on one level has run away and is dropped [px of that level]");
    param(
        "min_gradient", min_gradient, Range{0.0, 50.0},
        "root of the mean squared gradient, in its weaker direction, that a window needs [grey levels / px]");
    param("remove_mean", remove_mean, YesNo{}, "compare windows by their difference from their own mean");
    param("forward_backward_px", forward_backward_px, Range{0.0, 20.0},
          "drop corners that do not come back this near when tracked forth again; 0: no check [px]");
    param("check_levels", check_levels, Range{1, 8}, "finest pyramid levels that this check uses");
  }
};

struct OpticalFlowParams {
  CornerParams corners;
  TrackerParams tracker;

  void visit(auto&& param) {
    corners.visit(param);
    tracker.visit(param);
  }
};

}  // namespace hindsight
