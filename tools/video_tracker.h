// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The whole of chapter 3 on a video: flow, tracks, and an activity map anchored to the first picture.
#pragma once

#include <array>
#include <memory>
#include <opencv2/core.hpp>
#include <span>

#include "perception/activity_anchor.h"
#include "perception/activity_learner.h"
#include "perception/activity_map.h"
#include "perception/activity_prior.h"
#include "perception/motion_tracker.h"
#include "perception/optical_flow.h"

namespace hindsight::tools {

/// Cells of 16 px of the first picture, speeds to 12 px/frame.
constexpr ActivityMapParams kPictureActivity{.cell = 16.0, .cells = 256, .max_speed = 12.0};

/// One tracker; several may follow one video, each with a prior of its own or none.
class VideoTracker {
 public:
  VideoTracker(const MotionParams& params, cv::Size size);

  /// May be null.
  void use(std::shared_ptr<ActivityPrior> prior) { prior_ = std::move(prior); }
  /// `H_G_image`: where the picture before lay in the map's frame, which is as near as a prior needs.
  const MotionReport& step(std::span<const FlowVector> flow, const Eigen::Matrix3d& H_G_image);
  const MotionReport& report() const { return tracker_.report(); }

 private:
  MotionTracker tracker_;
  std::shared_ptr<ActivityPrior> prior_;
};

/// The ground that a picture of this size shows, in the map's frame.
std::array<Eigen::Vector2d, 4> view_of(cv::Size size, const Eigen::Matrix3d& H_G_image);

}  // namespace hindsight::tools
