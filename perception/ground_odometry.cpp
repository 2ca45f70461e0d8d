// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/ground_odometry.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "perception/ground_plane.h"

namespace hindsight {
namespace {

/// More would not make the way more exact than the ground is flat.
constexpr std::size_t kMostVectors = 400;
constexpr int kIterations = 8;
constexpr double kEqualWeights = std::numeric_limits<double>::infinity();
/// Deviation in one axis from the median of both together (Rayleigh).
constexpr double kMedianToSigma = 1.0 / 1.1774;
constexpr double kLeastScale_rad = 1e-4;
/// Cauchy's weights with this many deviations lose a twentieth of the efficiency of least squares.
constexpr double kCauchy = 2.385;
/// A vector within two pixels of a usual camera agrees.
constexpr double kAgrees_rad = 0.005;

}  // namespace

GroundOdometry::GroundOdometry(const GroundOdometryParams& params, const CameraModel& camera)
    : params_(params), camera_(camera) {
  rows_.reserve(kMostVectors);
  sorted_rad_.reserve(kMostVectors);
}

OdometryMotion GroundOdometry::measure(std::span<const FlowVector> flow) {
  OdometryMotion measured;
  collect(flow);
  if (rows_.size() < static_cast<std::size_t>(params_.min_vectors)) return measured;
  Fit fitted = fit(kEqualWeights);
  for (int i = 0; i < kIterations; ++i) fitted = fit(judge_residuals(fitted.motion));
  const double scale_rad = judge_residuals(fitted.motion);
  measured.vectors = static_cast<int>(std::count_if(
      rows_.begin(), rows_.end(), [](const Row& row) { return row.residual_rad < kAgrees_rad; }));
  // Pitching forward about B's origin carries the camera above it forward.
  measured.forward_m = fitted.motion(0) - camera_.p_BC_m.z() * fitted.motion(2);
  measured.turn_rad = fitted.motion(3);
  const Eigen::Vector4d of_way = fitted.normal.ldlt().solve(Eigen::Vector4d::UnitX());
  measured.sigma_m = scale_rad * std::sqrt(of_way(0));
  measured.valid = measured.vectors >= params_.min_vectors &&
                   measured.vectors >= params_.min_share * static_cast<double>(rows_.size()) &&
                   measured.sigma_m <= params_.max_sigma_m && fitted.motion.allFinite();
  return measured;
}

/// Of the vectors that lie on near ground in both frames, evenly.
void GroundOdometry::collect(std::span<const FlowVector> flow) {
  rows_.clear();
  const auto near_ground = [&](float x_px, float y_px) -> std::optional<Point2> {
    const auto p = ground_point(camera_, {static_cast<double>(x_px), static_cast<double>(y_px)});
    return p && std::hypot(p->x_m, p->y_m) <= params_.max_range_m ? p : std::nullopt;
  };
  const std::size_t stride = 1 + flow.size() / kMostVectors;
  for (std::size_t i = 0; i < flow.size(); i += stride) {
    const auto now = near_ground(flow[i].x_px, flow[i].y_px);
    if (!now) continue;
    const auto then = near_ground(flow[i].x_px + flow[i].dx_px, flow[i].y_px + flow[i].dy_px);
    if (then) rows_.push_back(row_of(*now, *then));
  }
}

/// The ray r to a point of the ground turns by w x r and meets the ground elsewhere. Taken half-way between
/// both points it holds up to the second order.
GroundOdometry::Row GroundOdometry::row_of(Point2 now_B_m, Point2 then_B_m) const {
  const double x_m = 0.5 * (now_B_m.x_m + then_B_m.x_m), y_m = 0.5 * (now_B_m.y_m + then_B_m.y_m);
  const double x = x_m - camera_.p_BC_m.x(), y = y_m - camera_.p_BC_m.y(), h = camera_.p_BC_m.z();
  Row row;
  row.J << 1.0, x * y / h, -(h + x * x / h), -y_m,  //
      0.0, h + y * y / h, -x * y / h, x_m;
  row.shift_rad << then_B_m.x_m - now_B_m.x_m, then_B_m.y_m - now_B_m.y_m;
  const double length2_m2 = x * x + y * y + h * h;
  const Eigen::Vector2d rad_per_m(h / length2_m2, 1.0 / std::sqrt(length2_m2));
  row.J = rad_per_m.asDiagonal() * row.J;
  row.shift_rad = rad_per_m.cwiseProduct(row.shift_rad);
  return row;
}

GroundOdometry::Fit GroundOdometry::fit(double scale_rad) const {
  Fit fitted{Motion::Zero(), Eigen::Matrix4d::Zero()};
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  for (const Row& row : rows_) {
    const double r = row.residual_rad / (kCauchy * scale_rad);
    const double weight = 1.0 / (1.0 + r * r);
    fitted.normal += weight * row.J.transpose() * row.J;
    b += weight * row.J.transpose() * row.shift_rad;
  }
  fitted.motion = fitted.normal.ldlt().solve(b);
  return fitted;
}

/// Gives every row its residual; returns their deviation, robustly.
double GroundOdometry::judge_residuals(const Motion& motion) {
  sorted_rad_.clear();
  for (Row& row : rows_) {
    row.residual_rad = (row.J * motion - row.shift_rad).norm();
    sorted_rad_.push_back(row.residual_rad);
  }
  const auto middle = sorted_rad_.begin() + static_cast<std::ptrdiff_t>(sorted_rad_.size() / 2);
  std::nth_element(sorted_rad_.begin(), middle, sorted_rad_.end());
  return std::max(kLeastScale_rad, kMedianToSigma * *middle);
}

}  // namespace hindsight
