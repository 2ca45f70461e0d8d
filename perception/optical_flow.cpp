// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/optical_flow.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace hindsight {

OpticalFlow::OpticalFlow(const OpticalFlowParams& params, int width_px, int height_px)
    : params_(params),
      detector_(params.corners, width_px, height_px),
      current_(width_px, height_px, params.tracker.pyramid_levels, params.tracker.prefilter_sigma_px),
      last_(current_) {
  const auto most = static_cast<std::size_t>(params.corners.max_features);
  tracked_.reserve(most);
  sorted_px_.reserve(most);
  corners_px_.reserve(most);
  matches_px_.reserve(most);
  flow_.reserve(most);
}

std::span<const FlowVector> OpticalFlow::update(std::span<const std::uint8_t> bgr) {
  std::swap(current_, last_);
  current_.build(bgr);
  features_ = detector_.detect(current_.level(0));
  flow_.clear();
  if (has_last_) track_into_last();
  has_last_ = true;
  return flow_;
}

/// In bands of rows from the top: neighbours are tracked one after the other, while what they are compared
/// with is in the processor's near cache.
void OpticalFlow::sort_features() {
  band_ends_.fill(0);
  for (const Point2f& p : features_) ++band_ends_[band_of(p)];
  std::exclusive_scan(band_ends_.begin(), band_ends_.end(), band_ends_.begin(), std::size_t{0});
  sorted_px_.resize(features_.size());
  for (const Point2f& p : features_) sorted_px_[band_ends_[band_of(p)]++] = p;
}

std::size_t OpticalFlow::band_of(Point2f p) const {
  return static_cast<std::size_t>(p.y_px) * band_ends_.size() /
         static_cast<std::size_t>(current_.level(0).height_px());
}

void OpticalFlow::track_into_last() {
  sort_features();
  tracked_.resize(sorted_px_.size());
  track_points(params_.tracker, current_, last_, current_.levels(), sorted_px_, sorted_px_, tracked_);
  corners_px_.clear();
  matches_px_.clear();
  for (std::size_t i = 0; i < sorted_px_.size(); ++i) {
    if (!tracked_[i].found) continue;
    corners_px_.push_back(sorted_px_[i]);
    matches_px_.push_back(tracked_[i].point_px);
  }
  const bool check = params_.tracker.forward_backward_px > 0.0;
  if (check) track_forth();
  for (std::size_t i = 0; i < corners_px_.size(); ++i) {
    if (check && !came_back(i)) continue;
    const Point2f now = corners_px_[i], then = matches_px_[i];
    flow_.push_back({now.x_px, now.y_px, then.x_px - now.x_px, then.y_px - now.y_px});
  }
}

/// Tracks the matches into the current frame again, beginning at the corners: where the windows really look
/// alike the way stays there, so that the finest levels are enough.
void OpticalFlow::track_forth() {
  tracked_.resize(matches_px_.size());
  track_points(params_.tracker, last_, current_, std::min(params_.tracker.check_levels, current_.levels()),
               matches_px_, corners_px_, tracked_);
}

bool OpticalFlow::came_back(std::size_t i) const {
  const double distance_px = std::hypot(tracked_[i].point_px.x_px - corners_px_[i].x_px,
                                        tracked_[i].point_px.y_px - corners_px_[i].y_px);
  return tracked_[i].found && distance_px <= params_.tracker.forward_backward_px;
}

}  // namespace hindsight
