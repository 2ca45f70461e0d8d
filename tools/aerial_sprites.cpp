// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/aerial_sprites.h"

#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace hindsight::tools {

cv::Mat mottled(cv::Size size, const cv::Scalar& bgr, double contrast, int finest_px, int coarsest_px,
                cv::RNG& random) {
  cv::Mat picture(size, CV_32FC3, bgr);
  for (int cell = finest_px; cell <= coarsest_px; cell *= 2) {
    cv::Mat coarse(size.height / cell + 2, size.width / cell + 2, CV_32FC1), octave;
    random.fill(coarse, cv::RNG::NORMAL, 0.0, contrast);
    cv::resize(coarse, octave, size, 0.0, 0.0, cv::INTER_CUBIC);
    cv::cvtColor(octave, octave, cv::COLOR_GRAY2BGR);
    picture += octave;
  }
  picture.convertTo(picture, CV_8UC3);
  return picture;
}

cv::Mat opaque(const cv::Mat& bgr) {
  cv::Mat bgra;
  cv::cvtColor(bgr, bgra, cv::COLOR_BGR2BGRA);
  return bgra;
}

cv::Mat round_cut(const cv::Mat& bgr, cv::RNG& random) {
  cv::Mat alpha(bgr.size(), CV_8UC1, cv::Scalar(0));
  std::vector<cv::Point> outline;
  for (int i = 0; i < 24; ++i) {
    const double a = i * CV_PI / 12.0, r = random.uniform(0.38, 0.5);
    outline.emplace_back(cvRound(bgr.cols * (0.5 + r * std::cos(a))),
                         cvRound(bgr.rows * (0.5 + r * std::sin(a))));
  }
  cv::fillPoly(alpha, std::vector{outline}, cv::Scalar(255));
  std::vector<cv::Mat> planes;
  cv::split(bgr, planes);
  planes.push_back(alpha);
  cv::Mat bgra;
  cv::merge(planes, bgra);
  return bgra;
}

cv::Scalar some_color(cv::RNG& random) {
  static const std::array<cv::Scalar, 7> kColors{
      cv::Scalar{40, 40, 180}, {190, 190, 190}, {40, 40, 40}, {170, 90, 30},
      {235, 235, 235},         {60, 120, 60},   {90, 90, 100}};
  return kColors[static_cast<std::size_t>(random.uniform(0, static_cast<int>(kColors.size())))];
}

/// Windscreen, rear window, lights: what a car looks like from above, nose to the right.
cv::Mat car_from_above(cv::RNG& random) {
  const cv::Scalar paint = some_color(random);
  cv::Mat car = mottled({90, 36}, paint, 3.0, 2, 8, random);
  cv::rectangle(car, {55, 4, 13, 28}, {50, 45, 40}, cv::FILLED);
  cv::rectangle(car, {14, 5, 9, 26}, {55, 50, 45}, cv::FILLED);
  cv::rectangle(car, {24, 5, 30, 26}, paint * 0.9, 1);
  cv::rectangle(car, {85, 3, 5, 7}, {240, 250, 250}, cv::FILLED);
  cv::rectangle(car, {85, 26, 5, 7}, {240, 250, 250}, cv::FILLED);
  cv::rectangle(car, {0, 3, 3, 6}, {40, 40, 220}, cv::FILLED);
  cv::rectangle(car, {0, 27, 3, 6}, {40, 40, 220}, cv::FILLED);
  cv::GaussianBlur(car, car, {3, 3}, 0.7);
  return opaque(car);
}

/// Shoulders and head, walking to the right; for a cyclist, between two wheels.
cv::Mat person_from_above(const cv::Scalar& shirt, int stride, bool cycle) {
  cv::Mat p(cycle ? cv::Size(96, 32) : cv::Size(40, 32), CV_8UC4, cv::Scalar(0, 0, 0, 0));
  const auto solid = [](cv::Scalar c) {
    c[3] = 255.0;
    return c;
  };
  const cv::Point middle(p.cols / 2, p.rows / 2);
  if (cycle) cv::line(p, {4, middle.y}, {p.cols - 5, middle.y}, solid({30, 30, 30}), 5);
  if (cycle) cv::line(p, {p.cols - 22, 6}, {p.cols - 22, p.rows - 7}, solid({60, 60, 60}), 4);
  cv::ellipse(p, middle, {11, 15}, 0, 0, 360, solid(shirt), cv::FILLED);
  cv::circle(p, middle + cv::Point(stride, -12), 4, solid({70, 95, 140}), cv::FILLED);
  cv::circle(p, middle + cv::Point(-stride, 12), 4, solid({70, 95, 140}), cv::FILLED);
  cv::circle(p, middle + cv::Point(2, 0), 7, solid({20, 28, 45}), cv::FILLED);
  return p;
}

}  // namespace hindsight::tools
