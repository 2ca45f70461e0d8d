// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Lines over axes, as a picture for a folder of results.
#pragma once

#include <opencv2/core.hpp>
#include <span>
#include <string>

#include "tools/report_style.h"

namespace hindsight::tools {

struct PngAxis {
  double min = 0.0;
  double max = 1.0;
  std::string label;         ///< with its unit
  bool logarithmic = false;  ///< min above 0 then; values below it are drawn at it
};

class PngChart {
 public:
  PngChart(const std::string& title, PngAxis x, PngAxis y);

  /// Points in the axes' units, in order, each marked; values outside the axes are cut off. `name` goes into
  /// the key.
  void line(std::span<const cv::Point2d> points, const Rgb& color, const std::string& name);
  /// A faint line across at a value of x or y.
  void mark_x(double x);
  void mark_y(double y);

  const cv::Mat& picture() const { return picture_; }

 private:
  void draw_frame(const std::string& title);
  cv::Point2d at(cv::Point2d p) const;

  PngAxis x_, y_;
  cv::Mat picture_;
  int keys_ = 0;
};

/// A colour for the i-th of several lines.
Rgb color_of_line(std::size_t i);

}  // namespace hindsight::tools
