// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/bench_templates.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "perception/template_row.h"
#include "tools/cpu_time.h"
#include "tools/road_method.h"

namespace hindsight::tools {
namespace {

constexpr int kStrips = 10, kHeight = 20, kNarrowest = 100, kWidest = 300;
constexpr int kRounds = 5;

/// Strips become narrower towards the top, as a road does.
cv::Rect strip_rect(int i, cv::Size size) {
  const int width = kWidest - i * (kWidest - kNarrowest) / (kStrips - 1);
  return {(size.width - width) / 2, size.height - (i + 1) * (size.height / 2 / kStrips) - kHeight, width,
          kHeight};
}

ColorView view(const cv::Mat& frame) { return {{frame.data, frame.total() * 3}, frame.cols, frame.rows}; }

}  // namespace

TemplateBench bench_templates(std::span<const cv::Mat> bgr_frames) {
  const cv::Size size = bgr_frames.front().size();
  std::vector<TemplateRow> rows;
  for (int i = 0; i < kStrips; ++i) rows.emplace_back(size.width, kWidest, kHeight);
  TemplateBench result;
  std::vector<double> opencv_us, ours_us;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t t = 1; t < bgr_frames.size(); ++t) {
      double opencv = 0.0, ours = 0.0;
      for (int i = 0; i < kStrips; ++i) {
        const cv::Rect rect = strip_rect(i, size);
        TemplateRow& row = rows[static_cast<std::size_t>(i)];
        row.take(view(bgr_frames[t - 1]), rect.x, rect.y, rect.width, rect.height);
        cv::Mat expected;
        opencv += microseconds([&] {
          cv::matchTemplate(bgr_frames[t].rowRange(rect.y, rect.y + kHeight), bgr_frames[t - 1](rect),
                            expected, cv::TM_SQDIFF_NORMED);
        });
        std::span<const float> found;
        ours += microseconds(
            [&] { found = row.search(view(bgr_frames[t]), rect.y, TemplateMatch::squared_difference); });
        for (std::size_t x = 0; x < found.size(); ++x) {
          const double off =
              std::abs(static_cast<double>(found[x] - expected.at<float>(static_cast<int>(x))));
          result.largest_difference = std::max(result.largest_difference, off);
        }
      }
      opencv_us.push_back(opencv);
      ours_us.push_back(ours);
    }
  }
  result.opencv_ms = quantile(opencv_us, 0.5) * 1e-3;
  result.ours_ms = quantile(ours_us, 0.5) * 1e-3;
  return result;
}

double bench_road_ms(std::span<const cv::Mat> bgr_frames) {
  RoadMethodSetup setup;
  setup.size = bgr_frames.front().size();
  // The camera is taken for level: with a horizon, a road on slopes is looked for, too.
  setup.horizon_row_px = 0.46 * setup.size.height;
  setup.configuration.road.min_history_s = 0.0;
  const std::unique_ptr<RoadMethod> method = make_road_follower(setup);
  std::vector<double> took_us;
  for (int round = 0; round < kRounds; ++round) {
    for (const cv::Mat& frame : bgr_frames) {
      method->see(frame, true);
      if (round > 0) took_us.push_back(method->took_us());
    }
  }
  return quantile(took_us, 0.5) * 1e-3;
}

}  // namespace hindsight::tools
