// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/sight.h"

#include "perception/road_horizon.h"

namespace hindsight {
namespace {

/// Beyond these, two frames have too little in common for flow between them to mean anything.
constexpr std::uint32_t kMostFramesLost = 5;
constexpr Time kLongestPause = from_seconds(1.0);
/// Beyond this, the road's place on flat ground is a guess.
constexpr double kRoadRange_m = 40.0;

}  // namespace

Sight::Sight(const Configuration& configuration, const CameraModel& camera)
    : camera_(camera),
      width_px_(camera.width_px),
      height_px_(camera.height_px),
      flow_(configuration.flow, width_px_, height_px_),
      history_(configuration.flow_history, width_px_, height_px_),
      appearance_(configuration.appearance, configuration.flow_history.depth + 1, width_px_, height_px_),
      ground_(camera, configuration.bottom_finder.max_range_m),
      bottom_finder_(configuration.bottom_finder, camera, ground_, configuration.evidence_grid.resolution_m),
      segmenter_(width_px_, height_px_),
      labeller_(configuration.labels, width_px_, height_px_, configuration.appearance.shrink) {
  if (configuration.ground_slip.enabled) odometry_.emplace(configuration.ground_odometry, camera);
  if (configuration.road.enabled || configuration.robot.mode == "road") {
    road_.emplace(configuration.road,
                  RoadPicture{width_px_, height_px_, configuration.appearance.shrink, horizon_row_px(camera)},
                  configuration.flow_history.depth);
  }
}

bool Sight::interrupted(const Frame& frame) const {
  return frame.sequence - last_sequence_ > kMostFramesLost + 1 || frame.stamp < last_stamp_ ||
         frame.stamp - last_stamp_ > kLongestPause;
}

void Sight::forget() {
  flow_.reset();
  history_.clear();
  appearance_.clear();
  any_frame_ = false;
  if (road_) road_->reset();
}

void Sight::follow_road(Time dt) {
  const RoadEstimate& road = road_->update({vectors_, history_, appearance_, to_seconds(dt)});
  road_on_ground_ = hindsight::road_on_ground(road, camera_, kRoadRange_m);
}

bool Sight::see(const Frame& frame) {
  if (frame.width_px != width_px_ || frame.height_px != height_px_) return false;
  if (any_frame_ && interrupted(frame)) forget();
  vectors_ = flow_.update(frame.bgr);
  ground_step_.reset();
  if (any_frame_) history_.push(vectors_);
  if (any_frame_ && odometry_) ground_step_ = GroundStep{last_stamp_, frame.stamp, odometry_->measure(vectors_)};
  appearance_.push(frame.bgr);
  if (road_) follow_road(any_frame_ ? frame.stamp - last_stamp_ : Time{});
  any_frame_ = true;
  last_stamp_ = frame.stamp;
  last_sequence_ = frame.sequence;
  return true;
}

void Sight::classify(const Frame& frame, const TerrainMixture& mixture, const TextureModel& texture) {
  labels_ = labeller_.label(segmenter_.segment(frame.bgr, mixture), appearance_.picture(0), texture);
  votes_ = bottom_finder_.find(labels_);
}

}  // namespace hindsight
