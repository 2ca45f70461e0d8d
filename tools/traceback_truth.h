// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Where a thing seen in the newest frame was in earlier ones: from true depths and poses of a still world.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "perception/camera_model.h"
#include "sim_replay/world/world.h"
#include "tools/pose_in_world.h"

namespace hindsight::tools {

class TracebackTruth {
 public:
  /// A thing hides another where the depths differ by more than this part.
  static constexpr double kSameDepth = 0.1;

  /// Remembers `frames` before the newest one; of these, the depths of every `every`-th.
  TracebackTruth(const CameraModel& camera, int frames, int every);

  /// depth_m: along the optical axis, row by row; infinite: sky.
  void push(const BodyPose& X_WB, const std::vector<float>& depth_m);
  /// Frames before the newest one.
  int size() const { return std::min(pushed_ - 1, frames_); }

  struct Place {
    ImagePoint px;
    double distance_m = 0.0;  ///< from the camera, then
    bool left_view = false;   ///< it was outside of the picture in between
  };
  /// Where what the newest frame shows at a pixel was `frames_back` frames before. Empty where that is the
  /// sky, was outside of the picture or hidden then, or is not known: frames_back is not in [1, size()] or
  /// not of those with depths.
  std::optional<Place> place_of(int column, int row, int frames_back) const;

 private:
  struct Snapshot {
    Eigen::Isometry3d X_BW;
    int number = 0;
  };
  std::optional<ImagePoint> in_picture(const Eigen::Vector3d& p_W_m, int frames_back) const;
  double depth_at(ImagePoint px, int frames_back) const;
  const Snapshot& snapshot(int frames_back) const;
  const std::vector<float>& depths(int number) const;

  CameraModel camera_;
  int frames_;
  int every_;
  int pushed_ = 0;
  std::vector<Snapshot> snapshots_;         ///< ring over frames
  std::vector<std::vector<float>> depths_;  ///< ring over every every_-th frame
  std::vector<float> newest_depth_m_;
};

}  // namespace hindsight::tools
