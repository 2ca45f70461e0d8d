// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/reference_tracks.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

namespace hindsight::tools {
namespace {

constexpr int kWindowPx = 21;
constexpr int kMaxLevel = 4;
constexpr int kMaxTracks = 2000;
constexpr int kSpacingPx = 12;
constexpr double kQuality = 0.001;
constexpr double kForwardBackwardPx = 0.5;

struct Tracked {
  std::vector<cv::Point2f> points;
  std::vector<unsigned char> found;
};

Tracked track(const cv::Mat& from, const cv::Mat& to, const std::vector<cv::Point2f>& points) {
  Tracked result;
  std::vector<float> residuals;
  cv::calcOpticalFlowPyrLK(from, to, points, result.points, result.found, residuals, {kWindowPx, kWindowPx},
                           kMaxLevel);
  return result;
}

}  // namespace

std::vector<ReferenceTrack> ReferenceTracks::advance(const cv::Mat& bgr) {
  cv::Mat grey;
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  std::vector<ReferenceTrack> ended = extend(grey);
  start_new(grey);
  last_grey_ = grey;
  return ended;
}

std::vector<ReferenceTrack> ReferenceTracks::extend(const cv::Mat& grey) {
  if (alive_.empty()) return {};
  std::vector<cv::Point2f> ends;
  for (const auto& track : alive_) ends.push_back(track.back());
  const Tracked forth = track(last_grey_, grey, ends);
  const Tracked back = track(grey, last_grey_, forth.points);
  const cv::Rect2f image(0.0F, 0.0F, static_cast<float>(grey.cols), static_cast<float>(grey.rows));
  std::vector<ReferenceTrack> ended, extended;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const bool good = forth.found[i] != 0 && back.found[i] != 0 && image.contains(forth.points[i]) &&
                      cv::norm(back.points[i] - ends[i]) < kForwardBackwardPx;
    if (good) alive_[i].push_back(forth.points[i]);
    (good ? extended : ended).push_back(std::move(alive_[i]));
  }
  alive_ = std::move(extended);
  return ended;
}

void ReferenceTracks::start_new(const cv::Mat& grey) {
  const int room = kMaxTracks - static_cast<int>(alive_.size());
  if (room <= 0) return;
  cv::Mat free(grey.size(), CV_8U, cv::Scalar(255));
  for (const auto& track : alive_) cv::circle(free, track.back(), kSpacingPx, cv::Scalar(0), cv::FILLED);
  std::vector<cv::Point2f> corners;
  cv::goodFeaturesToTrack(grey, corners, room, kQuality, kSpacingPx, free);
  for (const auto& corner : corners) alive_.push_back({corner});
}

}  // namespace hindsight::tools
