// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What of the flow is the camera's own motion, and which features move by themselves (thesis 3.1.2).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "config/params.h"
#include "perception/flow_vector.h"

namespace hindsight {

/// One point of the scene in two frames.
struct PointPair {
  Point2f now_px;
  Point2f then_px;
};

/// The thesis: affine, start "static", noise_px 1, and alpha as it is here.
struct EgoMotionParams {
  std::string model = "homography";
  std::string start = "samples";
  double log_alpha = -2.0;
  double noise_px = 0.0;
  double noise_factor = 2.5;
  double min_noise_px = 0.1;
  double max_residual_px = 4.0;
  int iterations = 6;

  void visit(auto&& param) {
    param("ego_model", model, Choices{"affine", "homography"},
          "how the ground's image moves between two frames");
    param("ego_start", start, Choices{"static", "samples"},
          "first fit: to all features, or to the sample that leaves the smallest median residual");
    param("log_alpha", log_alpha, Range{-20.0, 2.0},
          "logarithm of a moving feature's density, in parts of a static one's with no residual");
    param("noise_px", noise_px, Range{0.0, 20.0},
          "deviation of a static feature in each axis; 0: noise_factor x what the residuals show [px]");
    param("noise_factor", noise_factor, Range{0.5, 10.0}, "see noise_px");
    param("min_noise_px", min_noise_px, Range{0.01, 5.0}, "least deviation assumed [px]");
    param(
        "max_residual_px", max_residual_px, Range{0.1, 1000.0},
        "frames whose features fit one motion no better than this have nothing to do with one another [px]");
    param("em_iterations", iterations, Range{1, 50}, "of expectation and maximisation");
  }
};

/// How the image of the ground moved.
struct EgoMotion {
  Eigen::Matrix3d H_then_now = Eigen::Matrix3d::Identity();  ///< homogeneous points of now to those of then
  double residual_px = 0.0;   ///< deviation of the static features in each axis, as residuals show it
  double noise_px = 0.0;      ///< deviation that static features were given
  double static_share = 0.0;  ///< mean of p(c = 0)
  bool valid = false;         ///< false: too few features, or no motion that at least half of them agree on
};

/// Expectation and maximisation over c_i, "feature i moves". E-step: p(c = 1) = eta alpha (3.2), p(c = 0) =
/// eta exp(-D' D / (2 noise^2)) (3.3), D the residual. M-step: least squares weighted by p(c = 0), (3.1) or
/// its projective counterpart.
///
/// The thesis gives alpha = exp(2). Its static density is at most 1, so that with such an alpha even a
/// perfect match would move with probability 0.88: exp(-2) is meant, with which a residual of 2 noise_px is
/// as likely either way.
///
/// Deterministic (samples are drawn from a seed), no allocation in the steady state, one thread at a time.
class EgoMotionEstimator {
 public:
  EgoMotionEstimator(const EgoMotionParams& params, std::size_t max_pairs);

  /// `p_moving` gets p(c = 1) of each pair; of an invalid result it is 0 everywhere.
  EgoMotion estimate(std::span<const PointPair> pairs, std::span<float> p_moving);

 private:
  Eigen::Matrix3d start_from_samples(std::span<const PointPair> pairs);
  Eigen::Matrix3d fit_best_half(std::span<const PointPair> pairs, Eigen::Matrix3d H);
  Eigen::Matrix3d fit(std::span<const PointPair> pairs) const;
  void measure_residuals(std::span<const PointPair> pairs, const Eigen::Matrix3d& H);
  double robust_deviation_px();
  void expect(double noise_px);

  EgoMotionParams params_;
  bool projective_;
  std::vector<float> residual2_px2_;
  std::vector<float> sorted_px2_;
  std::vector<float> weight_;  ///< p(c = 0)
};

/// H applied to a point.
Point2f transformed(const Eigen::Matrix3d& H, Point2f p_px);

}  // namespace hindsight
