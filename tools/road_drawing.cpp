// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/road_drawing.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tools/report_style.h"
#include "tools/road_method.h"

namespace hindsight::tools {
namespace {

constexpr int kBand_px = 5;

/// Matches are stored at the pictures' stored size; `scale` brings them to this picture's.
void draw_matches(cv::Mat& picture, const TemplateRoad::SearchLine& line, int shrink) {
  const auto [best, worst] = std::minmax_element(line.response.begin(), line.response.end());
  const float range = std::max(*worst - *best, 1e-6F);
  const int row = static_cast<int>(std::lround(line.row_px));
  const int half = static_cast<int>(std::lround(line.width_px / 2.0F));
  for (std::size_t i = 0; i < line.response.size(); ++i) {
    const double light = 255.0 * static_cast<double>((*worst - line.response[i]) / range);
    const int x = static_cast<int>(i) * shrink + half;
    cv::rectangle(picture, cv::Point(x, row - kBand_px), cv::Point(x + shrink - 1, row + kBand_px),
                  cv::Scalar::all(light), cv::FILLED);
  }
  const int x = static_cast<int>(best - line.response.begin()) * shrink + half;
  cv::circle(picture, {x, row}, kBand_px, kInk.bgr(), cv::FILLED, cv::LINE_AA);
}

}  // namespace

void draw_road(cv::Mat& picture, const RoadFollower& follower) {
  if (const TemplateRoad* templates = follower.templates()) {
    for (const TemplateRoad::SearchLine& line : templates->lines())
      draw_matches(picture, line, templates->shrink());
  }
  const RoadEstimate& road = follower.estimate();
  if (road.count == 0) return;
  cv::polylines(picture, std::vector{polygon_of(road)}, true, kInk.bgr(), 4, cv::LINE_AA);
  cv::polylines(picture, std::vector{polygon_of(road)}, true, kStale.bgr(), 2, cv::LINE_AA);
  for (const RoadRow& row : road.rows()) {
    const cv::Point middle(static_cast<int>(std::lround(0.5F * (row.left_px + row.right_px))),
                           static_cast<int>(std::lround(row.row_px)));
    cv::circle(picture, middle, 3, kPaper.bgr(), cv::FILLED, cv::LINE_AA);
  }
}

}  // namespace hindsight::tools
