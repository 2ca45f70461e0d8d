// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A chart as SVG text, to be put into a page: sharp at any size, and text stays text.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/report_style.h"

namespace hindsight::tools {

struct ChartAxis {
  double min = 0.0;
  double max = 1.0;
  std::string label;  ///< with its unit
};

/// Marks at multiples of 1, 2 or 5 times a power of ten inside [min, max], about `about` of them.
std::vector<double> axis_marks(double min, double max, int about);

/// Everything is given in the axes' units and drawn in the order of the calls.
class SvgChart {
 public:
  SvgChart(int width_px, int height_px, ChartAxis x, ChartAxis y);

  /// Rows named instead of numbers at the y axis: row i covers [i, i + 1), the first on top.
  void name_rows(std::span<const std::string> names);

  /// x ascending; NaN breaks the line. Long lines are thinned to the extremes of each pixel column.
  void line(std::span<const double> x, std::span<const double> y, Rgb color, const std::string& name);
  void box(double x_from, double x_to, double y_from, double y_to, Rgb color, const std::string& tip = {},
           double opacity = 1.0);
  void vertical(double x, Rgb color, const std::string& tip, const std::string& label = {});
  void horizontal(double y, Rgb color, const std::string& label);
  /// An ellipse with axes along (x, y) turned by angle_rad towards y.
  void ellipse(double x, double y, double half_x, double half_y, double angle_rad, Rgb fill, Rgb stroke,
               const std::string& tip);
  /// A picture file beside the page, stretched over the range.
  void picture(const std::string& file, double x_from, double x_to, double y_from, double y_to);
  void legend(const std::string& name, Rgb color);

  std::string text() const;

 private:
  double x_px(double x) const;
  double y_px(double y) const;
  void draw_axes();
  void draw_row_names();

  int width_px_;
  int height_px_;
  ChartAxis x_;
  ChartAxis y_;
  std::vector<std::string> row_names_;
  std::string body_;
  std::string axes_;
  double legend_x_px_;
};

}  // namespace hindsight::tools
