// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/vehicle/chassis.h"

#include <algorithm>
#include <cmath>

#include "sim_replay/vehicle/ground_contact.h"

namespace hindsight {
namespace {

constexpr double kGravity_mps2 = 9.81;
constexpr double kMass_kg = 90.0;
constexpr double kYawInertia_kgm2 = 18.0;  // about the axle's middle
constexpr double kMassBehindAxle_m = 0.22;
constexpr double kMassHeight_m = 0.30;
constexpr double kCasterBehindAxle_m = 0.60;
constexpr double kScrub_nm = 12.0;
constexpr double kScrubStandstill_radps = 0.05;
constexpr double kStandstill_mps = 0.03;
constexpr double kBumperSpring_npm = 1500.0;
constexpr double kBushDrag_n = 40.0;
/// Tyres and ground are stiff: a period in one step would overshoot.
constexpr int kSubsteps = 10;

}  // namespace

void Chassis::step(double left_mps, double right_mps, const World& world, std::span<const Obstacle> nearby,
                   double dt_s) {
  const Footing under = footing(world);
  const double before_mps = speed_mps_;
  left_.steer_to(left_mps, dt_s);
  right_.steer_to(right_mps, dt_s);
  collided_ = false;
  for (int i = 0; i < kSubsteps; ++i) {
    accelerate(under, resist(nearby), dt_s / kSubsteps);
    go(dt_s / kSubsteps);
    collide(nearby);
  }
  acceleration_mps2_ = (speed_mps_ - before_mps) / dt_s;
}

Chassis::Footing Chassis::footing(const World& world) const {
  const double half_track_m = 0.5 * vehicle_.track_width_m;
  const GroundContact& left = contact_of(world.ground_at(X_WB_.to_world({0.0, half_track_m})));
  const GroundContact& right = contact_of(world.ground_at(X_WB_.to_world({0.0, -half_track_m})));
  const WorldPoint rise = world.terrain.gradient({X_WB_.x_m, X_WB_.y_m});
  const double c = std::cos(X_WB_.heading_rad), s = std::sin(X_WB_.heading_rad);
  const double ahead = c * rise.x_m + s * rise.y_m, leftwards = -s * rise.x_m + c * rise.y_m;
  const double weight_n = kMass_kg * kGravity_mps2 / std::sqrt(1.0 + ahead * ahead + leftwards * leftwards);
  // Uphill, weight goes from the front wheels to the caster; on a side slope, to the lower wheel.
  const double axle_n = weight_n * (1.0 - (kMassBehindAxle_m + kMassHeight_m * ahead) / kCasterBehindAxle_m);
  const double shift = std::clamp(kMassHeight_m * leftwards / vehicle_.track_width_m, -0.4, 0.4);
  const double left_n = std::max(0.0, axle_n * (0.5 - shift)),
               right_n = std::max(0.0, axle_n * (0.5 + shift));
  return {left.friction * left_n,
          right.friction * right_n,
          0.5 * (left.rolling + right.rolling) * weight_n,
          0.5 * (left.rolling_per_mps + right.rolling_per_mps) * weight_n,
          weight_n * ahead,
          weight_n * leftwards * kMassBehindAxle_m};
}

/// Static friction: what nothing moves does not creep.
bool Chassis::stands(const Footing& under, const Push& push) const {
  const bool still =
      std::abs(speed_mps_) < kStandstill_mps && std::abs(yaw_rate_radps_) < kScrubStandstill_radps;
  const bool told_to = left_.set_point_mps() == 0.0 && right_.set_point_mps() == 0.0;
  const double grip_n = under.left_grip_n + under.right_grip_n + under.rolling_n;
  return told_to && still && std::abs(under.downhill_n + push.back_n) < grip_n;
}

/// The bumper's springs, and bushes that are pushed through.
Chassis::Push Chassis::resist(std::span<const Obstacle> nearby) const {
  Push push;
  for (const Obstacle& obstacle : nearby) {
    const BodyContact contact = body_contact(vehicle_, X_WB_, obstacle);
    if (obstacle.drivable) {
      const double depth = std::clamp(-contact.gap_m / obstacle.radius_m, 0.0, 1.0);
      push.back_n += kBushDrag_n * depth * std::tanh(speed_mps_ / kStandstill_mps);
      continue;
    }
    const double force_n = kBumperSpring_npm * bumper_pressed_m(vehicle_, contact);
    push.back_n += force_n * contact.towards.x_m;
    push.turn_nm -= force_n * (contact.at.x_m * contact.towards.y_m - contact.at.y_m * contact.towards.x_m);
  }
  return push;
}

void Chassis::accelerate(const Footing& under, const Push& push, double dt_s) {
  const double half_track_m = 0.5 * vehicle_.track_width_m;
  const double left_n = left_.turn(speed_mps_ - yaw_rate_radps_ * half_track_m, under.left_grip_n, dt_s);
  const double right_n = right_.turn(speed_mps_ + yaw_rate_radps_ * half_track_m, under.right_grip_n, dt_s);
  if (stands(under, push)) {
    speed_mps_ = yaw_rate_radps_ = 0.0;
    left_.rest();
    right_.rest();
    return;
  }
  const double rolling_n =
      under.rolling_n * std::tanh(speed_mps_ / kStandstill_mps) + under.rolling_npmps * speed_mps_;
  const double scrub_nm = kScrub_nm * std::tanh(yaw_rate_radps_ / kScrubStandstill_radps);
  speed_mps_ += (left_n + right_n - rolling_n - under.downhill_n - push.back_n) / kMass_kg * dt_s;
  yaw_rate_radps_ += ((right_n - left_n) * half_track_m - scrub_nm + under.tail_turn_nm + push.turn_nm) /
                     kYawInertia_kgm2 * dt_s;
}

void Chassis::go(double dt_s) {
  const double heading_rad = X_WB_.heading_rad + 0.5 * yaw_rate_radps_ * dt_s;
  X_WB_.x_m += speed_mps_ * std::cos(heading_rad) * dt_s;
  X_WB_.y_m += speed_mps_ * std::sin(heading_rad) * dt_s;
  X_WB_.heading_rad += yaw_rate_radps_ * dt_s;
  distance_m_ += std::abs(speed_mps_) * dt_s;
}

void Chassis::collide(std::span<const Obstacle> nearby) {
  for (const Obstacle& obstacle : nearby) {
    if (obstacle.drivable) continue;
    const BodyContact contact = body_contact(vehicle_, X_WB_, obstacle);
    if (contact.gap_m < 0.0) stop_at(contact);
  }
}

/// Takes away the part of the motion that leads into the obstacle, by an impulse without rebound at the
/// contact point, and the overlap; what leads along it remains.
void Chassis::stop_at(const BodyContact& contact) {
  collided_ = true;
  const WorldPoint out =
      X_WB_.to_world({contact.gap_m * contact.towards.x_m, contact.gap_m * contact.towards.y_m});
  X_WB_.x_m = out.x_m;
  X_WB_.y_m = out.y_m;
  const double arm_m = contact.at.x_m * contact.towards.y_m - contact.at.y_m * contact.towards.x_m;
  const double into_mps = speed_mps_ * contact.towards.x_m + yaw_rate_radps_ * arm_m;
  if (into_mps <= 0.0) return;
  const double forward_part = contact.towards.x_m / kMass_kg, turning_part = arm_m / kYawInertia_kgm2;
  const double impulse_ns = into_mps / (contact.towards.x_m * forward_part + arm_m * turning_part);
  speed_mps_ -= impulse_ns * forward_part;
  yaw_rate_radps_ -= impulse_ns * turning_part;
}

}  // namespace hindsight
