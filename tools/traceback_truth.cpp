// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/traceback_truth.h"

#include <algorithm>
#include <cmath>

namespace hindsight::tools {

TracebackTruth::TracebackTruth(const CameraModel& camera, int frames, int every)
    : camera_(camera),
      frames_(frames),
      every_(every),
      snapshots_(static_cast<std::size_t>(frames) + 1),
      depths_(static_cast<std::size_t>(frames / every) + 1) {}

void TracebackTruth::push(const BodyPose& X_WB, const std::vector<float>& depth_m) {
  const int number = pushed_++;
  snapshots_[static_cast<std::size_t>(number) % snapshots_.size()] = {pose_in_world(X_WB).inverse(), number};
  newest_depth_m_ = depth_m;
  if (number % every_ == 0) depths_[static_cast<std::size_t>(number / every_) % depths_.size()] = depth_m;
}

const TracebackTruth::Snapshot& TracebackTruth::snapshot(int frames_back) const {
  return snapshots_[static_cast<std::size_t>(pushed_ - 1 - frames_back) % snapshots_.size()];
}

const std::vector<float>& TracebackTruth::depths(int number) const {
  return depths_[static_cast<std::size_t>(number / every_) % depths_.size()];
}

std::optional<ImagePoint> TracebackTruth::in_picture(const Eigen::Vector3d& p_W_m, int frames_back) const {
  const std::optional<ImagePoint> px = camera_.project(snapshot(frames_back).X_BW * p_W_m);
  const bool inside = px && px->x_px >= 0.0 && px->y_px >= 0.0 && px->x_px <= camera_.width_px - 1.0 &&
                      px->y_px <= camera_.height_px - 1.0;
  return inside ? px : std::nullopt;
}

double TracebackTruth::depth_at(ImagePoint px, int frames_back) const {
  const auto column = static_cast<std::size_t>(std::lround(px.x_px)),
             row = static_cast<std::size_t>(std::lround(px.y_px));
  return static_cast<double>(
      depths(snapshot(frames_back).number)[row * static_cast<std::size_t>(camera_.width_px) + column]);
}

std::optional<TracebackTruth::Place> TracebackTruth::place_of(int column, int row, int frames_back) const {
  if (frames_back < 1 || frames_back > size() || snapshot(frames_back).number % every_ != 0)
    return std::nullopt;
  const auto index = static_cast<std::size_t>(row) * static_cast<std::size_t>(camera_.width_px) +
                     static_cast<std::size_t>(column);
  const auto depth_m = static_cast<double>(newest_depth_m_[index]);
  if (!std::isfinite(depth_m)) return std::nullopt;
  const Eigen::Vector3d ray_B = camera_.ray_B({static_cast<double>(column), static_cast<double>(row)});
  const Eigen::Vector3d p_W = snapshot(0).X_BW.inverse() * (camera_.p_BC_m + depth_m * ray_B);
  const std::optional<ImagePoint> px = in_picture(p_W, frames_back);
  if (!px) return std::nullopt;
  const Eigen::Vector3d p_CP_B = snapshot(frames_back).X_BW * p_W - camera_.p_BC_m;
  const double depth_then_m = (camera_.R_BC.transpose() * p_CP_B).z();
  if (std::abs(depth_at(*px, frames_back) - depth_then_m) > kSameDepth * depth_then_m) return std::nullopt;
  Place place{*px, p_CP_B.norm(), false};
  for (int back = 1; back < frames_back && !place.left_view; ++back) place.left_view = !in_picture(p_W, back);
  return place;
}

}  // namespace hindsight::tools
