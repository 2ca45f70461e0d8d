// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "config/params.h"

namespace hindsight {

/// Road following (thesis 4). The thesis' method: see config/thesis.toml.
struct RoadParams {
  bool enabled = false;
  std::string method = "colors";
  double definition_centre = 0.5;
  double definition_width = 0.2;
  double definition_bottom = 0.92;
  int definition_height_px = 20;
  int refresh_frames = 10;
  double min_history_s = 7.0;

  // "templates"
  int templates = 10;
  std::string match = "squared_difference";
  int window_px = 5;
  std::string horizon = "sky";

  // "colors"
  int rows = 24;
  double color_memory_s = 10.0;
  double bend_cost = 3.0;
  double line_drift_per_s = 0.25;
  double lost_confidence = 0.12;
  double found_confidence = 0.2;
  double look_ahead_m = 5.0;

  void visit(auto&& param) {
    param("enabled", enabled, YesNo{}, "look for the road; costs nothing when off");
    param("method", method, Choices{"colors", "templates"},
          "colors: how the ground ahead was coloured all the way back, against what lies beside the road; "
          "templates: "
          "the thesis' strips");
    param("definition_centre", definition_centre, Range{0.0, 1.0},
          "middle of the strip ahead of the vehicle that is known to be road, in picture widths");
    param("definition_width", definition_width, Range{0.02, 1.0},
          "width of that strip, in picture widths; templates: as wide as the road, colors: no wider than the "
          "vehicle");
    param("definition_bottom", definition_bottom, Range{0.1, 1.0},
          "lower edge of that strip, in picture heights");
    param("definition_height_px", definition_height_px, Range{2, 100},
          "its height, and that of templates [px]");
    param("refresh_frames", refresh_frames, Range{1, 200}, "the strip is traced back once in so many frames");
    param("min_history_s", min_history_s, Range{0.0, 60.0},
          "no road is told before so much has been seen [s]");
    param("templates", templates, Range{2, 32}, "templates: how many, at even distances down the picture");
    param("match", match, Choices{"squared_difference", "correlation"},
          "templates: normalised squared difference, or zero-mean normalised correlation, to which light "
          "does not "
          "matter");
    param("window_px", window_px, Range{1, 200},
          "templates: how far the road moves aside from one template's row to the next [px]");
    param("horizon", horizon, Choices{"sky", "flow"},
          "templates: the horizon is the line between sky and ground, or moves as far things do");
    param("rows", rows, Range{6, 32}, "colors: rows in which the road is looked for");
    param("color_memory_s", color_memory_s, Range{0.5, 600.0}, "colors: how long colours are remembered [s]");
    param(
        "bend_cost", bend_cost, Range{0.0, 100.0},
        "colors: for a bend by the road's half width between two rows, squared; a row that fits is worth 2");
    param("line_drift_per_s", line_drift_per_s, Range{0.01, 10.0},
          "how far the middle wanders, one standard deviation, in the road's half widths a root second");
    param("lost_confidence", lost_confidence, Range{0.0, 1.0}, "no road here below this confidence");
    param("found_confidence", found_confidence, Range{0.0, 1.0}, "a lost road is there again from this on");
    param("look_ahead_m", look_ahead_m, Range{1.0, 50.0}, "mode road drives to its middle so far ahead [m]");
  }
};

}  // namespace hindsight
