// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/motion_parallax.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>

#include "perception/motion_feature.h"

namespace hindsight {
namespace {

constexpr int kSamples = 60;
constexpr std::size_t kFewest = 6;

constexpr float kAside = 0.8F;  ///< of noise_px: how far beside the line to the epipole a residual may point
constexpr float kEdge_px = 16.0F;
constexpr int kNeighbours = 2;
constexpr float kLonger = 2.0F;  ///< than the scene's mean residual: no edge of it moves so
constexpr int kPlaces = 3;       ///< that a scene must be seen in: any two residuals agree on some epipole
constexpr float kPlacesAcross = 8.0F;  ///< two places are an eighth of the picture's width apart or more

}  // namespace

/// Those that seem to move, or nearly so, as something above the plane would.
void ParallaxLayer::collect(std::span<const PointPair> pairs, const EgoMotion& motion) {
  residuals_.clear();
  const auto part = static_cast<float>(params_.parallax_part), noise_px = static_cast<float>(motion.noise_px);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Point2f on_plane = transformed(motion.H_then_now, pairs[i].now_px);
    const Eigen::Vector2f flow(on_plane.x_px - pairs[i].now_px.x_px, on_plane.y_px - pairs[i].now_px.y_px);
    const Eigen::Vector2f r(pairs[i].then_px.x_px - on_plane.x_px, pairs[i].then_px.y_px - on_plane.y_px);
    if (r.norm() < noise_px) continue;
    const bool above = r.dot(flow) > 0.0F && r.norm() <= part * flow.norm() + noise_px;
    const Eigen::Vector3f line =
        Eigen::Vector3f(on_plane.x_px, on_plane.y_px, 1.0F)
            .cross(Eigen::Vector3f(pairs[i].then_px.x_px, pairs[i].then_px.y_px, 1.0F));

    residuals_.push_back({above ? Verdict::open : Verdict::against, i, on_plane, r, line});
  }
}

bool ParallaxLayer::agrees(const Residual& residual, const Eigen::Vector3f& epipole, float sign,
                           float noise_px) const {
  Eigen::Vector2f d(epipole.x() - epipole.z() * residual.at_px.x_px,
                    epipole.y() - epipole.z() * residual.at_px.y_px);
  d *= sign;
  const float length = d.norm();
  if (residual.verdict == Verdict::against || !(length > 0.0F) || d.dot(residual.r_px) <= 0.0F) return false;
  return std::abs(d.x() * residual.r_px.y() - d.y() * residual.r_px.x()) <= kAside * noise_px * length;
}

/// Of the agreeing residuals, how many lie apart from one another; counts no further than is asked for.
int ParallaxLayer::count_places(const Eigen::Vector3f& epipole, float sign, float noise_px,
                                float apart_px) const {
  std::array<Point2f, kPlaces> places;
  int count = 0;
  for (const Residual& r : residuals_) {
    if (count == kPlaces) break;
    const auto end = places.begin() + count;
    const auto agreeing = [&](const Residual& other) { return agrees(other, epipole, sign, noise_px); };
    // A stray error of the flow is no place: it takes a few residuals beside one another.
    if (!agreeing(r) || std::count_if(residuals_.begin(), residuals_.end(), [&](const Residual& other) {
                          return distance_px(r.at_px, other.at_px) < kEdge_px && agreeing(other);
                        }) <= kNeighbours) {
      continue;
    }
    if (std::any_of(places.begin(), end, [&](Point2f p) { return distance_px(p, r.at_px) < apart_px; })) {
      continue;
    }
    places[static_cast<std::size_t>(count++)] = r.at_px;
  }
  return count;
}

/// Where a roof's edge covers and uncovers the ground, corners are made of both, and move as neither does.
void ParallaxLayer::excuse_edges(float longest_px, std::span<float> p_moving) const {
  for (const Residual& r : residuals_) {
    if (r.verdict == Verdict::excused || r.r_px.norm() > longest_px) continue;
    const auto beside = std::count_if(residuals_.begin(), residuals_.end(), [&](const Residual& other) {
      return other.verdict == Verdict::excused && distance_px(r.at_px, other.at_px) < kEdge_px;
    });
    if (beside >= kNeighbours) p_moving[r.pair] = 0.0F;
  }
}

std::size_t ParallaxLayer::excuse(std::span<const PointPair> pairs, const EgoMotion& motion, int width_px,
                                  std::span<float> p_moving) {
  if (params_.parallax_part <= 0.0 || !motion.valid) return 0;
  collect(pairs, motion);
  if (residuals_.size() < kFewest) return 0;
  const auto noise_px = static_cast<float>(motion.noise_px);
  cv::RNG random(19980600);
  Eigen::Vector3f best_epipole = Eigen::Vector3f::Zero();
  float best_sign = 1.0F;
  std::size_t most = 0;
  const auto count =
      static_cast<int>(std::partition(residuals_.begin(), residuals_.end(),
                                      [](const Residual& r) { return r.verdict == Verdict::open; }) -
                       residuals_.begin());
  if (count < static_cast<int>(kFewest)) return 0;
  for (int k = 0; k < kSamples; ++k) {
    const Residual& a = residuals_[static_cast<std::size_t>(random.uniform(0, count))];
    const Residual& b = residuals_[static_cast<std::size_t>(random.uniform(0, count))];
    const Eigen::Vector3f epipole = a.line.cross(b.line).normalized();
    for (const float sign : {1.0F, -1.0F}) {
      const auto agreeing = static_cast<std::size_t>(
          std::count_if(residuals_.begin(), residuals_.end(),
                        [&](const Residual& r) { return agrees(r, epipole, sign, noise_px); }));
      if (agreeing > most) most = agreeing, best_epipole = epipole, best_sign = sign;
    }
  }
  const int places =
      count_places(best_epipole, best_sign, noise_px, static_cast<float>(width_px) / kPlacesAcross);
  const bool large =
      static_cast<double>(most) >= params_.parallax_features * static_cast<double>(pairs.size());
  if (most < kFewest || (!large && places < kPlaces)) return 0;
  float length_px = 0.0F;
  for (Residual& r : residuals_) {
    if (!agrees(r, best_epipole, best_sign, noise_px)) continue;
    r.verdict = Verdict::excused;
    p_moving[r.pair] = 0.0F;
    length_px += r.r_px.norm();
  }
  excuse_edges(kLonger * length_px / static_cast<float>(most) + noise_px, p_moving);
  return most;
}

}  // namespace hindsight
