// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/road_baselines.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace hindsight::tools {
namespace {

constexpr double kHue = 10.0, kSaturation = 20.0, kValue = 20.0;
constexpr double kHueCircle = 180.0;
constexpr int kTexture_px = 20;
constexpr double kAlike = 0.9;

/// Mean of angles given in OpenCV's half degrees.
double mean_hue(const cv::Mat& hsv) {
  double sine = 0.0, cosine = 0.0;
  for (auto pixel = hsv.begin<cv::Vec3b>(); pixel != hsv.end<cv::Vec3b>(); ++pixel) {
    sine += std::sin((*pixel)[0] * CV_PI / 90.0);
    cosine += std::cos((*pixel)[0] * CV_PI / 90.0);
  }
  return std::fmod(std::atan2(sine, cosine) * 90.0 / CV_PI + kHueCircle, kHueCircle);
}

}  // namespace

cv::Mat hsv_road(const cv::Mat& bgr, const cv::Rect& region) {
  cv::Mat hsv;
  cv::cvtColor(bgr, hsv, cv::COLOR_BGR2HSV);
  const cv::Mat inside = hsv(region).clone();
  const cv::Scalar mean = cv::mean(inside);
  const double hue = mean_hue(inside);
  cv::Mat mask(bgr.size(), CV_8U);
  for (int row = 0; row < hsv.rows; ++row) {
    for (int column = 0; column < hsv.cols; ++column) {
      const auto& c = hsv.at<cv::Vec3b>(row, column);
      const bool alike = std::abs(std::remainder(c[0] - hue, kHueCircle)) <= kHue &&
                         std::abs(c[1] - mean[1]) <= kSaturation && std::abs(c[2] - mean[2]) <= kValue;
      mask.at<std::uint8_t>(row, column) = alike ? 1 : 0;
    }
  }
  return mask;
}

cv::Mat texture_road(const cv::Mat& bgr, const cv::Rect& region) {
  const cv::Point middle(region.x + region.width / 2, region.y + region.height / 2);
  const cv::Point corner(std::clamp(middle.x - kTexture_px / 2, 0, bgr.cols - kTexture_px),
                         std::clamp(middle.y - kTexture_px / 2, 0, bgr.rows - kTexture_px));
  cv::Mat difference;
  cv::matchTemplate(bgr, bgr(cv::Rect(corner, cv::Size(kTexture_px, kTexture_px))), difference,
                    cv::TM_SQDIFF);
  std::vector<float> inside;
  for (int x = region.x; x + kTexture_px <= region.br().x; ++x) {
    if (corner.y < difference.rows) inside.push_back(difference.at<float>(corner.y, x));
  }
  cv::Mat mask = cv::Mat::zeros(bgr.size(), CV_8U);
  if (inside.empty()) return mask;
  const auto limit =
      inside.begin() + static_cast<std::ptrdiff_t>(kAlike * static_cast<double>(inside.size() - 1));
  std::nth_element(inside.begin(), limit, inside.end());
  // A window's place is its middle.
  cv::Mat alike = difference <= *limit;
  alike.copyTo(mask(cv::Rect(cv::Point(kTexture_px / 2, kTexture_px / 2), difference.size())));
  return mask;
}

}  // namespace hindsight::tools
