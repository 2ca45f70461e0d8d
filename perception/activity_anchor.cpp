// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/activity_anchor.h"

#include <Eigen/LU>
#include <algorithm>

namespace hindsight {
namespace {

constexpr std::size_t kMostKeyframes = 24, kCorners = 200, kFewestFound = 30;
constexpr double kNewKeyframeBelow = 0.6;  ///< overlap with the best
constexpr int kGrid = 6;
constexpr float kMargin_px = 8.0F;

}  // namespace

ActivityAnchor::ActivityAnchor(const TrackerParams& tracker, int width_px, int height_px)
    : tracker_(tracker), width_px_(width_px), height_px_(height_px), estimator_({}, kCorners) {
  keyframes_.reserve(kMostKeyframes);
}

bool ActivityAnchor::update(const ImagePyramid& picture, std::span<const Point2f> corners,
                            const EgoMotion& ego) {
  if (keyframes_.empty()) {
    keep(picture, corners);
    return placed_ = true;
  }
  if (!placed_ || !ego.valid) {
    placed_ = std::any_of(keyframes_.begin(), keyframes_.end(),
                          [&](const Keyframe& key) { return place_against(key, picture, key.H_G_key); });
    return placed_;
  }
  H_G_image_ = H_G_image_ * ego.H_then_now;
  const auto best =
      std::max_element(keyframes_.begin(), keyframes_.end(), [this](const Keyframe& a, const Keyframe& b) {
        return overlap(a, H_G_image_) < overlap(b, H_G_image_);
      });
  const bool near = overlap(*best, H_G_image_) >= kNewKeyframeBelow;
  place_against(*best, picture, H_G_image_);
  if (!near && keyframes_.size() < kMostKeyframes) keep(picture, corners);
  return true;
}

/// Part of a grid over the picture that the keyframe shows too.
double ActivityAnchor::overlap(const Keyframe& key, const Eigen::Matrix3d& H_G_image) const {
  const Eigen::Matrix3d H_key_image = key.H_G_key.inverse() * H_G_image;
  int inside = 0;
  for (int i = 0; i < kGrid * kGrid; ++i) {
    const auto at = [](int k, int size) {
      return (static_cast<float>(k) + 0.5F) * static_cast<float>(size) / kGrid;
    };
    const Point2f p = transformed(H_key_image, {at(i % kGrid, width_px_), at(i / kGrid, height_px_)});
    inside += p.x_px >= 0.0F && p.y_px >= 0.0F && p.x_px < static_cast<float>(width_px_) &&
              p.y_px < static_cast<float>(height_px_);
  }
  return static_cast<double>(inside) / (kGrid * kGrid);
}

bool ActivityAnchor::place_against(const Keyframe& key, const ImagePyramid& picture,
                                   const Eigen::Matrix3d& H_G_guess) {
  const Eigen::Matrix3d H_image_key = H_G_guess.inverse() * key.H_G_key;
  points_.clear(), guesses_.clear(), pairs_.clear();
  for (const Point2f& corner : key.corners) {
    const Point2f guess = transformed(H_image_key, corner);
    if (guess.x_px < kMargin_px || guess.y_px < kMargin_px ||
        guess.x_px > static_cast<float>(width_px_) - kMargin_px ||
        guess.y_px > static_cast<float>(height_px_) - kMargin_px) {
      continue;
    }
    points_.push_back(corner), guesses_.push_back(guess);
  }
  tracked_.resize(points_.size());
  track_points(tracker_, key.picture, picture, picture.levels(), points_, guesses_, tracked_);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (tracked_[i].found) pairs_.push_back({tracked_[i].point_px, points_[i]});
  }
  p_moving_.resize(pairs_.size());
  const EgoMotion motion = estimator_.estimate(pairs_, p_moving_);
  if (!motion.valid || motion.static_share * static_cast<double>(pairs_.size()) < kFewestFound) return false;
  H_G_image_ = key.H_G_key * motion.H_then_now;
  return true;
}

void ActivityAnchor::keep(const ImagePyramid& picture, std::span<const Point2f> corners) {
  const auto most = std::min(kCorners, corners.size());
  keyframes_.push_back(
      {picture, {corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(most)}, H_G_image_});
}

}  // namespace hindsight
