// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// How far the vehicle moved over the ground between two frames, as the flow of the ground ahead shows it.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "config/params.h"
#include "drivers/samples.h"
#include "perception/camera_model.h"
#include "perception/flow_vector.h"
#include "perception/pose.h"

namespace hindsight {

struct GroundOdometryParams {
  double max_range_m = 4.0;
  int min_vectors = 30;
  double min_share = 0.6;
  double max_sigma_m = 0.02;

  void visit(auto&& param) {
    param("max_range_m", max_range_m, Range{0.5, 50.0}, "ground so far ahead is looked at [m]");
    param("min_vectors", min_vectors, Range{5, 400}, "fewer vectors that agree tell nothing");
    param("min_share", min_share, Range{0.1, 1.0}, "nor do vectors of which a smaller share agrees");
    param("max_sigma_m", max_sigma_m, Range{1e-4, 1.0},
          "nor those that leave a larger standard deviation of the way [m]");
  }
};

/// Motion from the frame before to the newest one.
struct OdometryMotion {
  bool valid = false;      ///< false: too little ground in view that agrees; the rest has no meaning then
  double forward_m = 0.0;  ///< of B's origin along its x axis
  double turn_rad = 0.0;   ///< counter-clockwise
  double sigma_m = 0.0;    ///< standard deviation of forward_m, as the residuals show it
  int vectors = 0;         ///< that agree
};

/// The same with the times of both frames.
struct GroundStep {
  Time from{};
  Time to{};
  OdometryMotion motion;
};

/// Visual odometry on ground taken to be flat. A vector is two points of the plane z = 0 of B; between them
/// lie the way that was driven and small rotations about three axes, as the chassis pitches and rolls over
/// bumps. Least squares over these four, in viewing angle, where errors are alike; vectors weigh by how well
/// they agree (Cauchy's weights), so that things that stand on the ground and wrong matches lose theirs.
///
/// Deterministic, no allocation after construction, one thread at a time.
class GroundOdometry {
 public:
  GroundOdometry(const GroundOdometryParams& params, const CameraModel& camera);

  OdometryMotion measure(std::span<const FlowVector> flow_t_to_t_minus_1);

 private:
  using Motion = Eigen::Vector4d;  ///< the camera's way forward [m]; its rotation about x, y, z of B [rad]
  /// What one vector asks of the motion: J * motion = shift.
  struct Row {
    Eigen::Matrix<double, 2, 4> J;
    Eigen::Vector2d shift_rad;
    double residual_rad = 0.0;
  };
  struct Fit {
    Motion motion;
    Eigen::Matrix4d normal;  ///< weighted J' J
  };

  void collect(std::span<const FlowVector> flow);
  Row row_of(Point2 now_B_m, Point2 then_B_m) const;
  Fit fit(double scale_rad) const;
  double judge_residuals(const Motion& motion);

  GroundOdometryParams params_;
  CameraModel camera_;
  std::vector<Row> rows_;
  std::vector<double> sorted_rad_;
};

}  // namespace hindsight
