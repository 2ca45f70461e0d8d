// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Where the newest picture lies in the picture plane of a first one: the activity map's frame G from the air
// (thesis 3.1.4).
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "perception/ego_motion.h"
#include "perception/image_pyramid.h"
#include "perception/lucas_kanade.h"

namespace hindsight {

/// Chains ego-motion, and registers every picture against the keyframe that shows most of it, so that errors
/// do not add up from frame to frame: while a keyframe is in sight there is no drift; from one keyframe to
/// the next, what one registration is wrong by; coming back to an old keyframe takes all of it away again.
///
/// Allocates when it takes a keyframe. Not thread-safe.
class ActivityAnchor {
 public:
  ActivityAnchor(const TrackerParams& tracker, int width_px, int height_px);

  /// The newest picture, its corners (strongest first), and how it moved since the one before. The first
  /// picture ever is G. False where the picture cannot be placed: after a cut to a place that no keyframe
  /// shows.
  bool update(const ImagePyramid& picture, std::span<const Point2f> corners, const EgoMotion& ego);
  /// Another video of the same place begins: the next picture is looked for among all keyframes.
  void start_over() { placed_ = false; }

  const Eigen::Matrix3d& H_G_image() const { return H_G_image_; }
  std::size_t keyframes() const { return keyframes_.size(); }

 private:
  struct Keyframe {
    ImagePyramid picture;
    std::vector<Point2f> corners;
    Eigen::Matrix3d H_G_key;
  };
  double overlap(const Keyframe& key, const Eigen::Matrix3d& H_G_image) const;
  bool place_against(const Keyframe& key, const ImagePyramid& picture, const Eigen::Matrix3d& H_G_guess);
  void keep(const ImagePyramid& picture, std::span<const Point2f> corners);

  TrackerParams tracker_;
  int width_px_, height_px_;
  EgoMotionEstimator estimator_;
  std::vector<Keyframe> keyframes_;
  bool placed_ = false;
  Eigen::Matrix3d H_G_image_ = Eigen::Matrix3d::Identity();
  std::vector<Point2f> points_, guesses_;
  std::vector<TrackedPoint> tracked_;
  std::vector<PointPair> pairs_;
  std::vector<float> p_moving_;
};

}  // namespace hindsight
