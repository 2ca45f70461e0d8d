// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "config/params.h"
#include "perception/motion_feature.h"

namespace hindsight {

/// What an object usually does where it is; the activity map's side of (3.7).
class MotionPrior {
 public:
  virtual ~MotionPrior() = default;
  /// p(v, theta | x, y), in 0 to 1; 0 where nothing is known. Image point and velocity [px/frame].
  virtual double probability(Point2f at_px, Point2f v_px) const = 0;
  /// A velocity from p(v, theta | x, y) for `uniform` in [0, 1); false where nothing is known.
  virtual bool sample(Point2f at_px, double uniform, Point2f& v_px) const = 0;
  /// Natural logarithm of how many times as often something moves so there as anything does anywhere; 0 where
  /// nothing is known.
  virtual double log_ratio(Point2f at_px, Point2f v_px) const = 0;
};

struct ParticleFilterParams {
  int particles = 150;
  double velocity_noise_px = 0.6;
  double weight_position_px = 8.0;
  double weight_velocity_px = 0.8;
  double peak_particles = 0.1;
  double map_factor = 5.0;
  double map_particles = 0.03;

  void visit(auto&& param) {
    param("particles", particles, Range{10, 5000}, "of each tracked object");
    param("velocity_noise_px", velocity_noise_px, Range{0.0, 100.0},
          "half range of the uniform noise that a particle's velocity gets each frame [px/frame]");
    param("weight_position_px", weight_position_px, Range{0.5, 200.0},
          "deviation of a feature's place from the object's (Sigma_w of 3.6) [px]");
    param("weight_velocity_px", weight_velocity_px, Range{0.05, 100.0},
          "deviation of a feature's velocity from the object's (Sigma_w of 3.6) [px/frame]");
    param("peak_particles", peak_particles, Range{0.0, 1.0},
          "part of the particles that start anew each frame from the object's peak of motion");
    param("map_factor", map_factor, Range{0.0, 1000.0},
          "k of (3.7): what the activity map's probability adds to a particle's weight");
    param("map_particles", map_particles, Range{0.0, 1.0},
          "part of the particles that take a velocity usual at their place instead of noise");
  }
};

/// One tracked object: particles over place and velocity (thesis 3.1.3), in the newest image, velocity over
/// the ground. Seeded; no allocation after construction. Not thread-safe.
class ParticleFilter {
 public:
  struct Particle {
    Point2f at_px;
    Point2f v_px;
    float weight = 0.0F;
  };

  ParticleFilter(const ParticleFilterParams& params, std::uint64_t seed);

  /// Particles around a peak of motion.
  void start(Point2f at_px, Point2f v_px, const cv::RNG& random);
  /// (3.4), and the image's own motion: H_now_then takes points of the frame before into this one.
  void predict(const Eigen::Matrix3d& H_now_then, const MotionPrior* prior);
  /// Puts some of the particles at a peak of motion that is taken for the object's: it may have turned or
  /// sped up.
  void look_at(Point2f at_px, Point2f v_px);
  /// (3.5) and (3.6), with (3.7) if there is a prior; returns the mean weight that the features alone give.
  /// `half_size_px`: the object's features lie about so far from its middle.
  double weigh(std::span<const MovingFeature> features, double half_size_px, const MotionPrior* prior);
  void resample();

  Point2f at_px() const { return at_px_; }
  Point2f v_px() const { return v_px_; }
  double spread_px() const { return spread_px_; }
  std::span<const Particle> particles() const { return particles_; }

 private:
  void average();

  ParticleFilterParams params_;
  cv::RNG random_;
  std::vector<Particle> particles_, drawn_;
  Point2f at_px_, v_px_;
  double spread_px_ = 0.0;
};

}  // namespace hindsight
