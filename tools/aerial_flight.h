// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A flight over an aerial world: pictures, their flow, and where they lie in the map's frame.
#pragma once

#include <memory>
#include <optional>

#include "perception/activity_anchor.h"
#include "perception/motion_tracker.h"
#include "perception/optical_flow.h"
#include "tools/aerial_renderer.h"

namespace hindsight::tools {

constexpr double kFlight_hz = 10.0;

class AerialFlight {
 public:
  AerialFlight(AerialRenderer& renderer, AerialCamera camera, AerialTraffic traffic, double begin_s);

  /// The next picture and its flow to the one before.
  std::span<const FlowVector> step();
  const AerialFrame& frame() const { return frame_; }
  const OpticalFlow& flow() const { return flow_; }
  /// Of the world's ground to the newest picture: truth.
  cv::Matx33d H_image_ground() const;

 private:
  AerialRenderer& renderer_;
  AerialCamera camera_;
  AerialTraffic traffic_;
  double time_s_;
  double shown_s_ = 0.0;
  std::uint64_t shown_ = 0;
  AerialFrame frame_;
  OpticalFlow flow_;
};

}  // namespace hindsight::tools
