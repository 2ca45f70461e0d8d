// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/road_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <opencv2/core.hpp>

#include "config/exit_code.h"
#include "tools/road_labels.h"
#include "tools/road_method.h"

namespace hindsight::tools {
namespace {

constexpr auto kRoad = static_cast<std::uint8_t>(RoadTruthPixel::road);
constexpr auto kOther = static_cast<std::uint8_t>(RoadTruthPixel::other);

/// Road where it is road in at least half of the scored frames that judge the pixel: the best that one shape
/// can do.
cv::Mat average_road(const RoadEvaluation& evaluation, const RoadTruth& truth,
                     std::span<const std::size_t> scored, cv::Size size) {
  cv::Mat votes = cv::Mat::zeros(size, CV_32S);
  for (const std::size_t i : scored) {
    const cv::Mat mask = truth.mask(evaluation.frames[i].name, size);
    cv::add(votes, 1, votes, mask == kRoad);
    cv::subtract(votes, 1, votes, mask == kOther);
  }
  return votes > 0;
}

bool off_road(const cv::Mat& truth, const cv::Rect& region) {
  const cv::Mat inside = truth(region & cv::Rect({}, truth.size()));
  return cv::countNonZero(inside == kRoad) < cv::countNonZero(inside == kOther);
}

std::unique_ptr<RoadMethod> make_method(const RoadEvaluation& evaluation, const RoadTruth& truth,
                                        std::span<const std::size_t> scored, cv::Size size) {
  const RoadMethodSetup setup{evaluation.configuration, size, evaluation.rate_hz, evaluation.horizon_row_px};
  if (evaluation.method == "ours" || evaluation.method == "thesis") return make_road_follower(setup);
  if (evaluation.method == "constant")
    return make_constant_road(average_road(evaluation, truth, scored, size));
  return make_road_baseline(evaluation.method, setup);
}

}  // namespace

std::vector<std::size_t> frames_to_score(const RoadEvaluation& evaluation, const RoadTruth& truth) {
  const double history_s = evaluation.configuration.road.min_history_s;
  const double length_s = static_cast<double>(evaluation.frames.size()) / evaluation.rate_hz;
  if (length_s <= history_s) {
    throw FatalError(kExitBadData,
                     fmt::format("{} frames at {} Hz are {:.1f} s; a road follower needs {} s of history "
                                 "before it is scored",
                                 evaluation.frames.size(), evaluation.rate_hz, length_s, history_s));
  }
  const auto first = static_cast<std::size_t>(std::ceil(history_s * evaluation.rate_hz));
  const auto apart = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(evaluation.rate_hz)));
  std::vector<std::size_t> scored;
  for (std::size_t i = first; i < evaluation.frames.size(); ++i) {
    if (truth.has(evaluation.frames[i].name) && (scored.empty() || i >= scored.back() + apart))
      scored.push_back(i);
  }
  if (scored.empty()) {
    throw FatalError(kExitBadData,
                     fmt::format("no truth after the first {} s ({} frames), which are needed as history",
                                 history_s, first));
  }
  return scored;
}

RoadEvaluationResult evaluate_road(const RoadEvaluation& evaluation, const RoadTruth& truth,
                                   const RoadWatcher& watch,
                                   const std::function<void(std::size_t)>& progress) {
  const std::vector<std::size_t> scored = frames_to_score(evaluation, truth);
  const cv::Size size = read_road_frame(evaluation.frames.front().file, {}).size();
  const cv::Rect region = definition_rect(evaluation.configuration.road, size);
  const std::unique_ptr<RoadMethod> method = make_method(evaluation, truth, scored, size);
  RoadEvaluationResult result;
  double took_us = 0.0;
  auto next = scored.begin();
  for (std::size_t i = 0; i <= scored.back(); ++i) {
    const bool wanted = i == *next;
    if (!wanted && !method->looks_at_all()) continue;
    const cv::Mat bgr = read_road_frame(evaluation.frames[i].file, size);
    method->see(bgr, wanted);
    progress(i + 1);
    if (!wanted) continue;
    ++next;
    took_us += method->took_us();
    const std::string& name = evaluation.frames[i].name;
    const cv::Mat mask = truth.mask(name, size), called = method->road();
    if (off_road(mask, region)) ++result.off_road_frames;
    if (cv::countNonZero(called) == 0) ++result.silent_frames;
    if (const auto score = score_road(mask, called)) result.score.add(*score);
    const RoadFollower* follower = method->follower();
    if (follower != nullptr && !std::isfinite(follower->estimate().horizon_row_px))
      ++result.no_horizon_frames;
    watch(name, bgr, mask, called, *method);
  }
  if (result.off_road_frames == static_cast<int>(scored.size())) {
    throw FatalError(
        kExitBadData,
        fmt::format(
            "the definition region, columns {} to {}, rows {} to {}, is off the road in all of the {} "
            "scored frames; set road.definition_* with --config",
            region.x, region.br().x, region.y, region.br().y, scored.size()));
  }
  if (result.score.frames == 0) throw FatalError(kExitBadData, "the truth of no scored frame shows road");
  result.ms_per_frame = took_us * 1e-3 / static_cast<double>(scored.size());
  const double apart = scored.size() > 1 ? static_cast<double>(scored.back() - scored.front()) /
                                               static_cast<double>(scored.size() - 1)
                                         : 1.0;
  result.mttf_frames = result.score.mttf_frames(apart * static_cast<double>(scored.size()));
  return result;
}

}  // namespace hindsight::tools
