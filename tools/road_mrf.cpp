// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>

#include "tools/road_baselines.h"

namespace hindsight::tools {
namespace {

constexpr int kColumns = 320;
/// Those of Kato's program: weight of a pair of neighbours, start temperature, its factor for each sweep, and
/// the relative change of energy at which it stops.
constexpr double kBeta = 0.9, kStartTemperature = 4.0, kCooling = 0.98, kStopAtChange = 5e-4;
constexpr int kMostSweeps = 200;
constexpr double kVarianceFloor = 4.0;

struct ColorGaussian {
  cv::Vec3d mean;
  cv::Matx33d inverse;
  double log_norm = 0.0;

  /// The single potential: minus the log of the density, constants left out.
  double energy(const cv::Vec3b& c) const {
    const cv::Vec3d d(c[0] - mean[0], c[1] - mean[1], c[2] - mean[2]);
    return log_norm + 0.5 * d.dot(inverse * d);
  }
};

ColorGaussian fit(const cv::Mat& bgr) {
  cv::Mat covariance, mean;
  cv::Mat pixels = bgr.clone().reshape(1, static_cast<int>(bgr.total()));
  cv::calcCovarMatrix(pixels, covariance, mean, cv::COVAR_NORMAL | cv::COVAR_ROWS | cv::COVAR_SCALE, CV_64F);
  cv::Matx33d c(covariance.ptr<double>());
  for (int i = 0; i < 3; ++i) c(i, i) += kVarianceFloor;
  return {{mean.at<double>(0), mean.at<double>(1), mean.at<double>(2)},
          c.inv(),
          0.5 * std::log(cv::determinant(c))};
}

/// Labels of the neighbours above, below, left and right that differ from `label`, less those that agree.
int disagreement(const cv::Mat& labels, int row, int column, int label) {
  int sum = 0;
  for (const auto& [dy, dx] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
    const int y = row + dy, x = column + dx;
    if (y < 0 || x < 0 || y >= labels.rows || x >= labels.cols) continue;
    sum += labels.at<std::uint8_t>(y, x) == label ? -1 : 1;
  }
  return sum;
}

}  // namespace

cv::Mat mrf_road(const cv::Mat& bgr, const cv::Rect& region, std::uint64_t seed) {
  const double scale = std::min(1.0, static_cast<double>(kColumns) / bgr.cols);
  cv::Mat small;
  cv::resize(bgr, small, {}, scale, scale, cv::INTER_AREA);
  const cv::Rect frame({}, small.size());
  const cv::Rect road(cv::Point(static_cast<int>(region.x * scale), static_cast<int>(region.y * scale)),
                      cv::Size(std::max(2, static_cast<int>(region.width * scale)),
                               std::max(2, static_cast<int>(region.height * scale))));
  const int side = std::max(4, road.width / 2);
  const cv::Rect beside(0, std::clamp(road.y - side, 0, small.rows - side), side, side);
  const std::array classes{fit(small(beside & frame)), fit(small(road & frame))};
  cv::Mat labels(small.size(), CV_8U);
  cv::Mat single(small.size(), CV_64FC2);
  double energy = 0.0;
  for (int row = 0; row < small.rows; ++row) {
    for (int column = 0; column < small.cols; ++column) {
      const auto& c = small.at<cv::Vec3b>(row, column);
      const cv::Vec2d e(classes[0].energy(c), classes[1].energy(c));
      single.at<cv::Vec2d>(row, column) = e;
      labels.at<std::uint8_t>(row, column) = e[1] < e[0] ? 1 : 0;
      energy += std::min(e[0], e[1]);
    }
  }
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double temperature = kStartTemperature;
  for (int sweep = 0; sweep < kMostSweeps; ++sweep, temperature *= kCooling) {
    double change = 0.0;
    for (int row = 0; row < small.rows; ++row) {
      for (int column = 0; column < small.cols; ++column) {
        const int label = labels.at<std::uint8_t>(row, column), other = 1 - label;
        const auto& e = single.at<cv::Vec2d>(row, column);
        const double gain = e[other] - e[label] - 2.0 * kBeta * disagreement(labels, row, column, label);
        if (gain > 0.0 && uniform(random) >= std::exp(-gain / temperature)) continue;
        labels.at<std::uint8_t>(row, column) = static_cast<std::uint8_t>(other);
        change += gain;
      }
    }
    energy += change;
    if (std::abs(change) < kStopAtChange * std::abs(energy)) break;
  }
  cv::Mat mask;
  cv::resize(labels, mask, bgr.size(), 0.0, 0.0, cv::INTER_NEAREST);
  return mask;
}

}  // namespace hindsight::tools
