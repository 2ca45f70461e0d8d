// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/particle_filter.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "perception/ego_motion.h"

namespace hindsight {
namespace {

constexpr float kStartSpread_px = 3.0F;

float noise(cv::RNG& random, double half_range) {
  return static_cast<float>(random.uniform(-half_range, half_range));
}

/// How the homography turns and stretches what is small, at a point.
Eigen::Matrix2f jacobian(const Eigen::Matrix3d& H, Point2f p) {
  const Eigen::Vector3d x = H * Eigen::Vector3d(p.x_px, p.y_px, 1.0);
  Eigen::Matrix2d J;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) J(i, j) = (H(i, j) - x(i) / x(2) * H(2, j)) / x(2);
  }
  return J.cast<float>();
}

}  // namespace

ParticleFilter::ParticleFilter(const ParticleFilterParams& params, std::uint64_t seed)
    : params_(params),
      random_(seed),
      particles_(static_cast<std::size_t>(params.particles)),
      drawn_(particles_.size()) {}

void ParticleFilter::start(Point2f at_px, Point2f v_px, const cv::RNG& random) {
  random_ = random;
  for (Particle& p : particles_) {
    p.at_px = {at_px.x_px + noise(random_, kStartSpread_px), at_px.y_px + noise(random_, kStartSpread_px)};
    p.v_px = {v_px.x_px + noise(random_, params_.velocity_noise_px),
              v_px.y_px + noise(random_, params_.velocity_noise_px)};
    p.weight = 1.0F;
  }
  average();
}

void ParticleFilter::predict(const Eigen::Matrix3d& H_now_then, const MotionPrior* prior) {
  const Eigen::Matrix2f J = jacobian(H_now_then, at_px_);
  for (Particle& p : particles_) {
    const Eigen::Vector2f v = J * Eigen::Vector2f(p.v_px.x_px, p.v_px.y_px);
    p.v_px = {v.x(), v.y()};
    p.at_px = transformed(H_now_then, p.at_px);
    p.at_px.x_px += v.x(), p.at_px.y_px += v.y();
    Point2f usual;
    if (prior != nullptr && random_.uniform(0.0, 1.0) < params_.map_particles &&
        prior->sample(p.at_px, random_.uniform(0.0, 1.0), usual)) {
      p.v_px = usual;
      continue;
    }
    p.v_px.x_px += noise(random_, params_.velocity_noise_px);
    p.v_px.y_px += noise(random_, params_.velocity_noise_px);
  }
  average();
}

void ParticleFilter::look_at(Point2f at_px, Point2f v_px) {
  for (Particle& p : particles_) {
    if (random_.uniform(0.0, 1.0) >= params_.peak_particles) continue;
    p.at_px = {at_px.x_px + noise(random_, kStartSpread_px), at_px.y_px + noise(random_, kStartSpread_px)};
    p.v_px = {v_px.x_px + noise(random_, params_.velocity_noise_px),
              v_px.y_px + noise(random_, params_.velocity_noise_px)};
  }
}

double ParticleFilter::weigh(std::span<const MovingFeature> features, double half_size_px,
                             const MotionPrior* prior) {
  const double deviation_px = std::max(params_.weight_position_px, half_size_px);
  const auto per_px2 = static_cast<float>(-0.5 / (deviation_px * deviation_px));
  const auto per_v2 = static_cast<float>(-0.5 / (params_.weight_velocity_px * params_.weight_velocity_px));
  double sum = 0.0;
  for (Particle& p : particles_) {
    float weight = 0.0F;
    for (const MovingFeature& f : features) {
      const float dx = p.at_px.x_px - f.at_px.x_px, dy = p.at_px.y_px - f.at_px.y_px;
      const float du = p.v_px.x_px - f.v_px.x_px, dv = p.v_px.y_px - f.v_px.y_px;
      weight += f.probability * std::exp(per_px2 * (dx * dx + dy * dy) + per_v2 * (du * du + dv * dv));
    }
    sum += weight;
    if (prior != nullptr)
      weight += static_cast<float>(params_.map_factor * prior->probability(p.at_px, p.v_px));
    p.weight = weight;
  }
  return sum / static_cast<double>(particles_.size());
}

/// Systematic: one random number, evenly spaced draws. Weights that are all nothing leave the particles as
/// they are.
void ParticleFilter::resample() {
  double total = 0.0;
  for (const Particle& p : particles_) total += p.weight;
  if (total > 1e-12) {
    const double step = total / static_cast<double>(particles_.size());
    double pointer = random_.uniform(0.0, step), sum = 0.0;
    std::size_t from = 0;
    for (Particle& p : drawn_) {
      while (from + 1 < particles_.size() && sum + particles_[from].weight < pointer)
        sum += particles_[from++].weight;
      p = particles_[from];
      pointer += step;
    }
    std::swap(particles_, drawn_);
  }
  average();
}

void ParticleFilter::average() {
  double x = 0.0, y = 0.0, u = 0.0, v = 0.0, square = 0.0;
  for (const Particle& p : particles_)
    x += p.at_px.x_px, y += p.at_px.y_px, u += p.v_px.x_px, v += p.v_px.y_px;
  const auto n = static_cast<double>(particles_.size());
  at_px_ = {static_cast<float>(x / n), static_cast<float>(y / n)};
  v_px_ = {static_cast<float>(u / n), static_cast<float>(v / n)};
  for (const Particle& p : particles_) square += std::pow(distance_px(p.at_px, at_px_), 2.0);
  spread_px_ = std::sqrt(square / n);
}

}  // namespace hindsight
