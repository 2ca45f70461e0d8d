// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/road_score.h"

#include "tools/road_labels.h"

namespace hindsight::tools {
namespace {

struct Counts {
  int road = 0;
  int right = 0;  ///< road, called so
  int wrong = 0;  ///< other, called road

  double coverage() const { return road > 0 ? static_cast<double>(right - wrong) / road : 0.0; }
};

Counts count(const cv::Mat& truth, const cv::Mat& called) {
  Counts counts;
  for (int row = 0; row < truth.rows; ++row) {
    const auto* t = truth.ptr<std::uint8_t>(row);
    const auto* c = called.ptr<std::uint8_t>(row);
    for (int column = 0; column < truth.cols; ++column) {
      const bool road = t[column] == static_cast<std::uint8_t>(RoadTruthPixel::road);
      const bool other = t[column] == static_cast<std::uint8_t>(RoadTruthPixel::other);
      counts.road += road ? 1 : 0;
      counts.right += road && c[column] != 0 ? 1 : 0;
      counts.wrong += other && c[column] != 0 ? 1 : 0;
    }
  }
  return counts;
}

bool has_road(const cv::Mat& truth, int row) {
  return count(truth.row(row), cv::Mat::zeros(1, truth.cols, CV_8U)).road > 0;
}

}  // namespace

std::optional<RoadFrameScore> score_road(const cv::Mat& truth, const cv::Mat& called) {
  const Counts all = count(truth, called);
  if (all.road == 0) return std::nullopt;
  int top = 0, bottom = truth.rows - 1;
  while (!has_road(truth, top)) ++top;
  while (!has_road(truth, bottom)) --bottom;
  RoadFrameScore score;
  score.pixel_coverage = all.coverage();
  score.failed = all.right == 0;
  for (int line = 0; line < kRoadLines; ++line) {
    const double up = (line + 0.5) / kRoadLines;
    const int row = static_cast<int>(bottom - up * (bottom - top) + 0.5);
    score.line_coverage[static_cast<std::size_t>(line)] = count(truth.row(row), called.row(row)).coverage();
  }
  return score;
}

void RoadScore::add(const RoadFrameScore& frame) {
  ++frames;
  failures += frame.failed ? 1 : 0;
  pixel_coverage += (frame.pixel_coverage - pixel_coverage) / frames;
  for (std::size_t i = 0; i < line_coverage.size(); ++i)
    line_coverage[i] += (frame.line_coverage[i] - line_coverage[i]) / frames;
}

}  // namespace hindsight::tools
