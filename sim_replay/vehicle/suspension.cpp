// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/vehicle/suspension.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim_replay/vehicle/ground_contact.h"
#include "sim_replay/world/random.h"

namespace hindsight {
namespace {

constexpr double kCasterBehindAxle_m = 0.60;
constexpr double kSwing_radps = 2.0 * std::numbers::pi * 3.5;
constexpr double kDamping = 0.4;
/// The nose dips when braking.
constexpr double kPitchForAcceleration_radpmps2 = 0.008;
/// What tyres can do; a trunk stops the vehicle faster, but takes hold of it as low as they do.
constexpr double kMostAcceleration_mps2 = 8.0;
/// Of bumps that tyres still feel.
constexpr double kBumpLengths_m[] = {0.9, 0.35};
constexpr double kBumpWeights[] = {1.3, 0.8};

/// In [-1, 1], a fixed number for each corner of a grid.
double corner(std::uint64_t seed, std::int64_t i, std::int64_t j) {
  Random random(seed ^ (static_cast<std::uint64_t>(i) * 0x9E3779B1U) ^
                (static_cast<std::uint64_t>(j) << 32U));
  return random.uniform(-1.0, 1.0);
}

double smooth(double t) { return t * t * (3.0 - 2.0 * t); }

double value_noise(std::uint64_t seed, double x, double y) {
  const auto i = static_cast<std::int64_t>(std::floor(x)), j = static_cast<std::int64_t>(std::floor(y));
  const double u = smooth(x - std::floor(x)), v = smooth(y - std::floor(y));
  const double near_side = std::lerp(corner(seed, i, j), corner(seed, i + 1, j), u);
  const double far_side = std::lerp(corner(seed, i, j + 1), corner(seed, i + 1, j + 1), u);
  return std::lerp(near_side, far_side, v);
}

}  // namespace

Suspension::Suspension(const World& world, double track_width_m, const PlanarPose& start)
    : track_width_m_(track_width_m), seed_(world.seed) {
  const Stance at_rest = stance(world, start);
  z_.value = at_rest.z_m;
  pitch_.value = at_rest.pitch_rad;
  roll_.value = at_rest.roll_rad;
}

void Suspension::step(const World& world, const PlanarPose& X_WB, double acceleration_mps2, double dt_s) {
  const Stance target = stance(world, X_WB);
  z_.follow(target.z_m, dt_s);
  const double felt_mps2 = std::clamp(acceleration_mps2, -kMostAcceleration_mps2, kMostAcceleration_mps2);
  pitch_.follow(target.pitch_rad - kPitchForAcceleration_radpmps2 * felt_mps2, dt_s);
  roll_.follow(target.roll_rad, dt_s);
}

BodyPose Suspension::pose(const PlanarPose& X_WB) const {
  return {X_WB.x_m, X_WB.y_m, z_.value, X_WB.heading_rad, pitch_.value, roll_.value};
}

void Suspension::Spring::follow(double target, double dt_s) {
  rate += (kSwing_radps * kSwing_radps * (target - value) - 2.0 * kDamping * kSwing_radps * rate) * dt_s;
  value += rate * dt_s;
}

Suspension::Stance Suspension::stance(const World& world, const PlanarPose& X_WB) const {
  const double left_m = height_m(world, X_WB.to_world({0.0, 0.5 * track_width_m_}));
  const double right_m = height_m(world, X_WB.to_world({0.0, -0.5 * track_width_m_}));
  const double caster_m = height_m(world, X_WB.to_world({-kCasterBehindAxle_m, 0.0}));
  const double axle_m = 0.5 * (left_m + right_m);
  return {axle_m, std::atan2(caster_m - axle_m, kCasterBehindAxle_m),
          std::atan2(left_m - right_m, track_width_m_)};
}

double Suspension::height_m(const World& world, WorldPoint p) const {
  return world.terrain.height_m(p) + contact_of(world.ground_at(p)).bumps_m * bump(p);
}

double Suspension::bump(WorldPoint p) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < std::size(kBumpLengths_m); ++k) {
    sum += kBumpWeights[k] * value_noise(seed_ + k, p.x_m / kBumpLengths_m[k], p.y_m / kBumpLengths_m[k]);
  }
  return sum;
}

}  // namespace hindsight
