// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What stands above the ground seems to move over it when the camera does. It moves as one rigid scene would.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "config/params.h"
#include "perception/ego_motion.h"

namespace hindsight {

struct ParallaxParams {
  double parallax_part = 0.5;
  double parallax_features = 0.08;

  void visit(auto&& param) {
    param("parallax_part", parallax_part, Range{0.0, 10.0},
          "parallax is at most this part of the ground's flow: height / (camera's height - height); 0: not "
          "looked for");
    param("parallax_features", parallax_features, Range{0.0, 1.0},
          "part of all features, in one place, that a scene must be to be taken for it; or three places");
  }
};

/// After a plane's motion is taken out, what is left of a static point lies on the line to the epipole (Irani
/// and Anandan, "A unified approach to moving object detection in 2D and 3D scenes", 1998). Of the features
/// that seem to move, those are called static that agree on an epipole, all lie above the plane (their
/// residual goes the way the ground's flow goes, and is a part of it), and are not just one small thing. A
/// mover that keeps with the flow so exactly is missed as long as it does; one that the camera follows is
/// not, since its residual goes against the flow.
///
/// Deterministic, no allocation once the vectors have grown, one thread at a time.
class ParallaxLayer {
 public:
  explicit ParallaxLayer(const ParallaxParams& params) : params_(params) {}

  /// Sets p_moving of features that parallax explains to 0; returns how many.
  std::size_t excuse(std::span<const PointPair> pairs, const EgoMotion& motion, int width_px,
                     std::span<float> p_moving);

 private:
  enum class Verdict : std::uint8_t {
    open,
    against,
    excused
  };  ///< against: not as something above the plane would
  struct Residual {
    Verdict verdict;
    std::size_t pair;
    Point2f at_px;  ///< where the plane's motion takes it
    Eigen::Vector2f r_px;
    Eigen::Vector3f line;
  };
  void collect(std::span<const PointPair> pairs, const EgoMotion& motion);
  int count_places(const Eigen::Vector3f& epipole, float sign, float noise_px, float apart_px) const;
  void excuse_edges(float longest_px, std::span<float> p_moving) const;
  bool agrees(const Residual& residual, const Eigen::Vector3f& epipole, float sign, float noise_px) const;

  ParallaxParams params_;
  std::vector<Residual> residuals_;
};

}  // namespace hindsight
