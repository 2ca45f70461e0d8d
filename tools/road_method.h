// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "daemon/robot_config.h"
#include "perception/road_follower.h"

namespace hindsight::tools {

/// One way to find the road, shown a sequence frame by frame.
class RoadMethod {
 public:
  virtual ~RoadMethod() = default;
  /// Each frame of the sequence, 8-bit BGR, continuous; `wanted`: the road in it will be asked for.
  virtual void see(const cv::Mat& bgr, bool wanted) = 0;
  /// Whether it needs frames that nobody asks about.
  virtual bool looks_at_all() const { return false; }
  /// Mask of the newest frame, not 0 where road is.
  virtual cv::Mat road() const = 0;
  /// Processor time of the last see() without what the daemon does anyway (flow and histories) [us].
  virtual double took_us() const = 0;
  /// What it says, where it is a road follower; else null.
  virtual const RoadFollower* follower() const { return nullptr; }
};

/// Pixels of a road that a follower tells of.
cv::Mat mask_of(const RoadEstimate& estimate, cv::Size size);
std::vector<cv::Point> polygon_of(const RoadEstimate& estimate);

/// What a method is made from.
struct RoadMethodSetup {
  Configuration configuration;
  cv::Size size;
  double rate_hz = 10.0;
  double horizon_row_px = 0.0;  ///< NaN: the camera's mounting is not known
};

std::unique_ptr<RoadMethod> make_road_follower(const RoadMethodSetup& setup);
/// name: "mrf", "hsv" or "texture".
std::unique_ptr<RoadMethod> make_road_baseline(const std::string& name, const RoadMethodSetup& setup);
/// The same road in every frame, no vision.
std::unique_ptr<RoadMethod> make_constant_road(const cv::Mat& mask);

/// The definition region, whole pixels.
cv::Rect definition_rect(const RoadParams& params, cv::Size size);

}  // namespace hindsight::tools
