// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/png_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "tools/svg_chart.h"

namespace hindsight::tools {
namespace {

const cv::Size kPicture(1080, 560);
const cv::Rect kAxes(80, 50, 700, 430);
constexpr int kMarks = 6;
constexpr int kKeyHeight_px = 20;

void write(cv::Mat& picture, const std::string& words, cv::Point at, double size = 0.45) {
  cv::putText(picture, words, at, cv::FONT_HERSHEY_SIMPLEX, size, kInk.bgr(), 1, cv::LINE_AA);
}

/// 0 at the axis' minimum, 1 at its maximum.
double share(const PngAxis& axis, double value) {
  if (!axis.logarithmic) return (std::clamp(value, axis.min, axis.max) - axis.min) / (axis.max - axis.min);
  return std::log(std::clamp(value, axis.min, axis.max) / axis.min) / std::log(axis.max / axis.min);
}

std::vector<double> marks(const PngAxis& axis) {
  if (!axis.logarithmic) return axis_marks(axis.min, axis.max, kMarks);
  std::vector<double> decades;
  for (double decade = std::pow(10.0, std::ceil(std::log10(axis.min) - 1e-9)); decade <= axis.max * 1.001;
       decade *= 10.0)
    decades.push_back(decade);
  return decades;
}

}  // namespace

PngChart::PngChart(const std::string& title, PngAxis x, PngAxis y)
    : x_(std::move(x)), y_(std::move(y)), picture_(kPicture, CV_8UC3, kPaper.bgr()) {
  draw_frame(title);
}

void PngChart::draw_frame(const std::string& title) {
  write(picture_, title, {kAxes.x, 24}, 0.55);
  for (const double x : marks(x_)) {
    mark_x(x);
    write(picture_, fmt::format("{:g}", x), cv::Point(at({x, y_.min})) + cv::Point(-10, 20));
  }
  for (const double y : marks(y_)) {
    mark_y(y);
    write(picture_, fmt::format("{:g}", y), cv::Point(at({x_.min, y})) + cv::Point(-45, 5));
  }
  cv::rectangle(picture_, kAxes, kInk.bgr());
  write(picture_, x_.label, {kAxes.x + kAxes.width / 2 - 80, kAxes.br().y + 48}, 0.5);
  write(picture_, y_.label, {8, kAxes.y - 8}, 0.5);
}

cv::Point2d PngChart::at(cv::Point2d p) const {
  return {kAxes.x + share(x_, p.x) * kAxes.width, kAxes.y + (1.0 - share(y_, p.y)) * kAxes.height};
}

void PngChart::mark_x(double x) { cv::line(picture_, at({x, y_.min}), at({x, y_.max}), kFaint.bgr()); }

void PngChart::mark_y(double y) { cv::line(picture_, at({x_.min, y}), at({x_.max, y}), kFaint.bgr()); }

void PngChart::line(std::span<const cv::Point2d> points, const Rgb& color, const std::string& name) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) cv::line(picture_, at(points[i - 1]), at(points[i]), color.bgr(), 2, cv::LINE_AA);
    cv::circle(picture_, at(points[i]), 3, color.bgr(), cv::FILLED, cv::LINE_AA);
  }
  const cv::Point key(kAxes.br().x + 14, kAxes.y + 12 + kKeyHeight_px * keys_++);
  cv::line(picture_, key, key + cv::Point(18, 0), color.bgr(), 2, cv::LINE_AA);
  write(picture_, name, key + cv::Point(24, 5));
}

Rgb color_of_line(std::size_t i) {
  constexpr std::array kColors{kLethal,
                               kLeft,
                               kGood,
                               kBad,
                               kRight,
                               kAccent,
                               kInk,
                               kStale,
                               Rgb{140, 86, 75},
                               Rgb{227, 119, 194},
                               Rgb{127, 127, 127}};
  return kColors[i % kColors.size()];
}

}  // namespace hindsight::tools
