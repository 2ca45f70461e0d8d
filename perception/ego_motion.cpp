// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/ego_motion.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>

namespace hindsight {
namespace {

constexpr std::size_t kFewestPairs = 12;
constexpr int kSamples = 40;
constexpr std::size_t kJudges = 150;  ///< features that judge a sample
/// Coordinates about the middle of the image and near 1, which keeps the normal equations well conditioned.
constexpr double kScale_px = 300.0;
/// Residuals of a normal distribution in two axes are Rayleigh: its median and upper quartile.
constexpr double kMostTail = 1.5;
constexpr double kRayleighMedian = 1.1774, kRayleighQuartile = 1.6651;

using Normal = Eigen::Matrix<double, 8, 8>;
using Row = Eigen::Matrix<double, 8, 1>;

Eigen::Matrix3d normaliser(std::span<const PointPair> pairs) {
  double x = 0.0, y = 0.0;
  for (const PointPair& pair : pairs) x += pair.now_px.x_px, y += pair.now_px.y_px;
  const auto n = static_cast<double>(pairs.size());
  Eigen::Matrix3d T = Eigen::Matrix3d::Identity();
  T.diagonal() << 1.0 / kScale_px, 1.0 / kScale_px, 1.0;
  T(0, 2) = -x / n / kScale_px, T(1, 2) = -y / n / kScale_px;
  return T;
}

/// Weighted least squares of (3.1), or of its projective counterpart made linear by its denominator, from
/// pair(i) and weight(i).
Eigen::Matrix3d least_squares(std::size_t n, bool projective, const Eigen::Matrix3d& T, auto&& pair_of,
                              auto&& weight_of) {
  Normal A = Normal::Zero();
  Row b = Row::Zero();
  const double s = T(0, 0), tx = T(0, 2), ty = T(1, 2);
  // A' A and A' b, by blocks: [S 0 U; 0 S V; U' V' W], S of (x y 1), so that a pair costs few products.
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 2> U = Eigen::Matrix<double, 3, 2>::Zero(), V = U, R = U;
  Eigen::Matrix2d W = Eigen::Matrix2d::Zero();
  Eigen::Vector2d q = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    const PointPair& pair = pair_of(i);
    const double w = weight_of(i);
    const double x = s * pair.now_px.x_px + tx, y = s * pair.now_px.y_px + ty;
    const double u = s * pair.then_px.x_px + tx, v = s * pair.then_px.y_px + ty;
    const Eigen::Vector3d g(x, y, 1.0);
    const Eigen::Vector2d h(x, y);
    S += w * g * g.transpose();
    R.col(0) += w * u * g;
    R.col(1) += w * v * g;
    if (!projective) continue;
    U -= w * u * g * h.transpose();
    V -= w * v * g * h.transpose();
    W += w * (u * u + v * v) * h * h.transpose();
    q -= w * (u * u + v * v) * h;
  }
  A.block<3, 3>(0, 0) = A.block<3, 3>(3, 3) = S;
  A.block<3, 2>(0, 6) = U, A.block<3, 2>(3, 6) = V;
  A.block<2, 3>(6, 0) = U.transpose(), A.block<2, 3>(6, 3) = V.transpose();
  A.block<2, 2>(6, 6) = W;
  b << R.col(0), R.col(1), q;
  Eigen::Matrix3d H = Eigen::Matrix3d::Identity();
  Row solution = Row::Zero();
  if (projective) {
    solution = A.ldlt().solve(b);
  } else {
    solution.head<3>() = S.ldlt().solve(R.col(0));
    solution.segment<3>(3) = S.ldlt().solve(R.col(1));
  }
  H.row(0) = solution.head<3>(), H.row(1) = solution.segment<3>(3);
  H.row(2).head<2>() = solution.tail<2>();
  H = T.inverse() * H * T;
  return H / H(2, 2);
}

float squared_residual(const Eigen::Matrix3d& H, const PointPair& pair) {
  const Point2f then = transformed(H, pair.now_px);
  const float dx = then.x_px - pair.then_px.x_px, dy = then.y_px - pair.then_px.y_px;
  return dx * dx + dy * dy;
}

}  // namespace

Point2f transformed(const Eigen::Matrix3d& H, Point2f p_px) {
  const double x = p_px.x_px, y = p_px.y_px;
  const double w = 1.0 / (H(2, 0) * x + H(2, 1) * y + H(2, 2));
  return {static_cast<float>((H(0, 0) * x + H(0, 1) * y + H(0, 2)) * w),
          static_cast<float>((H(1, 0) * x + H(1, 1) * y + H(1, 2)) * w)};
}

EgoMotionEstimator::EgoMotionEstimator(const EgoMotionParams& params, std::size_t max_pairs)
    : params_(params), projective_(params.model == "homography") {
  residual2_px2_.reserve(max_pairs), sorted_px2_.reserve(max_pairs), weight_.reserve(max_pairs);
}

EgoMotion EgoMotionEstimator::estimate(std::span<const PointPair> pairs, std::span<float> p_moving) {
  EgoMotion motion;
  std::fill(p_moving.begin(), p_moving.end(), 0.0F);
  if (pairs.size() < kFewestPairs) return motion;
  weight_.assign(pairs.size(), 1.0F);
  motion.H_then_now = params_.start == "samples" ? start_from_samples(pairs) : fit(pairs);
  if (params_.start == "samples") motion.H_then_now = fit_best_half(pairs, motion.H_then_now);
  for (int i = 0;; ++i) {
    measure_residuals(pairs, motion.H_then_now);
    motion.residual_px = robust_deviation_px();
    motion.noise_px = params_.noise_px > 0.0
                          ? params_.noise_px
                          : std::max(params_.min_noise_px, params_.noise_factor * motion.residual_px);
    expect(motion.noise_px);
    if (i == params_.iterations) break;
    motion.H_then_now = fit(pairs);
  }
  double sum = 0.0;
  for (const float w : weight_) sum += w;
  motion.static_share = sum / static_cast<double>(pairs.size());
  motion.valid = motion.H_then_now.allFinite() && motion.static_share >= 0.5 &&
                 motion.residual_px <= params_.max_residual_px;
  if (!motion.valid) return motion;
  for (std::size_t i = 0; i < pairs.size(); ++i) p_moving[i] = 1.0F - weight_[i];
  return motion;
}

/// Least median of squares (Rousseeuw 1984) over affine fits to six features each: one large mover, or half a
/// frame of wrong matches, then does not pull the first fit.
Eigen::Matrix3d EgoMotionEstimator::start_from_samples(std::span<const PointPair> pairs) {
  constexpr std::size_t kOfEach = 6;
  cv::RNG random(20070410);  // the same draws for every frame: what is returned depends on the pairs alone
  const Eigen::Matrix3d T = normaliser(pairs);
  const std::size_t stride = std::max<std::size_t>(1, pairs.size() / kJudges);
  Eigen::Matrix3d best = fit(pairs);
  float best_px2 = INFINITY;
  std::array<std::size_t, kOfEach> sample{};
  for (int k = 0; k <= kSamples; ++k) {
    for (std::size_t& i : sample)
      i = static_cast<std::size_t>(random.uniform(0, static_cast<int>(pairs.size())));
    const Eigen::Matrix3d H =
        k == 0 ? best
               : least_squares(
                     kOfEach, false, T, [&](std::size_t i) -> const PointPair& { return pairs[sample[i]]; },
                     [](std::size_t) { return 1.0; });
    sorted_px2_.clear();
    for (std::size_t i = 0; i < pairs.size(); i += stride)
      sorted_px2_.push_back(squared_residual(H, pairs[i]));
    const auto middle = sorted_px2_.begin() + static_cast<std::ptrdiff_t>(sorted_px2_.size() / 2);
    std::nth_element(sorted_px2_.begin(), middle, sorted_px2_.end());
    if (*middle < best_px2) best = H, best_px2 = *middle;
  }
  return best;
}

/// Concentration steps (Rousseeuw and Van Driessen 1999): six features and an affine model do not show what
/// the camera's turning does to the picture, so that what is left of that would pass for noise, and a large
/// mover with it.
Eigen::Matrix3d EgoMotionEstimator::fit_best_half(std::span<const PointPair> pairs, Eigen::Matrix3d H) {
  constexpr int kSteps = 3;
  for (int step = 0; step < kSteps; ++step) {
    measure_residuals(pairs, H);
    sorted_px2_ = residual2_px2_;
    const auto middle = sorted_px2_.begin() + static_cast<std::ptrdiff_t>(sorted_px2_.size() / 2);
    std::nth_element(sorted_px2_.begin(), middle, sorted_px2_.end());
    for (std::size_t i = 0; i < pairs.size(); ++i) weight_[i] = residual2_px2_[i] <= *middle ? 1.0F : 0.0F;
    H = fit(pairs);
  }
  return H;
}

Eigen::Matrix3d EgoMotionEstimator::fit(std::span<const PointPair> pairs) const {
  return least_squares(
      pairs.size(), projective_, normaliser(pairs),
      [&](std::size_t i) -> const PointPair& { return pairs[i]; },
      [&](std::size_t i) { return static_cast<double>(weight_[i]); });
}

void EgoMotionEstimator::measure_residuals(std::span<const PointPair> pairs, const Eigen::Matrix3d& H) {
  residual2_px2_.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const float r2 = squared_residual(H, pairs[i]);
    residual2_px2_[i] = std::isfinite(r2) ? r2 : 1e12F;
  }
}

/// What the upper quartile says, which parallax makes larger than the median does; but not much more than
/// that, since more than a quarter of the features may move by themselves.
double EgoMotionEstimator::robust_deviation_px() {
  sorted_px2_ = residual2_px2_;
  const auto at = [this](double part) {
    const auto rank = static_cast<std::ptrdiff_t>(part * static_cast<double>(sorted_px2_.size() - 1));
    std::nth_element(sorted_px2_.begin(), sorted_px2_.begin() + rank, sorted_px2_.end());
    return std::sqrt(static_cast<double>(sorted_px2_[static_cast<std::size_t>(rank)]));
  };
  const double by_half = at(0.5) / kRayleighMedian;
  return std::clamp(at(0.75) / kRayleighQuartile, by_half, kMostTail * by_half);
}

/// (3.2) and (3.3).
void EgoMotionEstimator::expect(double noise_px) {
  const auto alpha = static_cast<float>(std::exp(params_.log_alpha));
  const auto factor = static_cast<float>(-0.5 / (noise_px * noise_px));
  for (std::size_t i = 0; i < weight_.size(); ++i) {
    const float is_static = std::exp(factor * residual2_px2_[i]);
    weight_[i] = is_static / (is_static + alpha);
  }
}

}  // namespace hindsight
