// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/road_picture.h"

#include <opencv2/imgproc.hpp>
#include <vector>

#include "tools/report_style.h"
#include "tools/road_labels.h"

namespace hindsight::tools {
namespace {

constexpr double kTint = 0.4;

}  // namespace

cv::Mat draw_called_road(const cv::Mat& bgr, const cv::Mat& truth, const cv::Mat& called) {
  cv::Mat picture = bgr.clone();
  const cv::Mat road = truth == static_cast<std::uint8_t>(RoadTruthPixel::road);
  cv::Mat tint = bgr.clone();
  tint.setTo(kGood.bgr(), (called != 0) & road);
  tint.setTo(kLethal.bgr(), (called != 0) & ~road);
  cv::addWeighted(bgr, 1.0 - kTint, tint, kTint, 0.0, picture);
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(road, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  cv::drawContours(picture, outlines, -1, kPaper.bgr(), 1, cv::LINE_AA);
  return picture;
}

}  // namespace hindsight::tools
