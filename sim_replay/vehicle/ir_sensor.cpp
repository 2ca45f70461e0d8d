// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/vehicle/ir_sensor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hindsight {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr int kRays = 9;
constexpr double kSigma_m = 0.01;
constexpr double kSigmaOfRange = 0.01;
/// What must come back: share of the cone times reflectivity over the range squared.
constexpr double kLeastEcho_1pm2 = 0.03;

/// In the near infrared: leaves are bright, bark is not, a mesh lets most pass.
double reflectivity(TruthLabel label) {
  switch (label) {
    case TruthLabel::bush:
      return 0.5;
    case TruthLabel::rock:
      return 0.4;
    case TruthLabel::fence:
      return 0.25;
    default:
      return 0.3;
  }
}

double to_disc_m(WorldPoint from, WorldPoint direction, WorldPoint middle, double radius_m) {
  const double dx = middle.x_m - from.x_m, dy = middle.y_m - from.y_m;
  const double along_m = dx * direction.x_m + dy * direction.y_m;
  const double aside_m = dx * direction.y_m - dy * direction.x_m;
  if (std::abs(aside_m) > radius_m) return kNever;
  const double half_chord_m = std::sqrt(radius_m * radius_m - aside_m * aside_m);
  return along_m + half_chord_m < 0.0 ? kNever : std::max(0.0, along_m - half_chord_m);
}

/// To the line a-b moved sideways by `offset_m`.
double to_side_m(WorldPoint from, WorldPoint direction, const Obstacle& obstacle, double offset_m) {
  const double ux = obstacle.b.x_m - obstacle.a.x_m, uy = obstacle.b.y_m - obstacle.a.y_m;
  const double length_m = std::hypot(ux, uy);
  const double cross = direction.x_m * uy - direction.y_m * ux;
  if (length_m == 0.0 || cross == 0.0) return kNever;
  const double dx = obstacle.a.x_m - uy / length_m * offset_m - from.x_m;
  const double dy = obstacle.a.y_m + ux / length_m * offset_m - from.y_m;
  const double range_m = (dx * uy - dy * ux) / cross;
  const double part = (dx * direction.y_m - dy * direction.x_m) / cross;
  return range_m >= 0.0 && part >= 0.0 && part <= 1.0 ? range_m : kNever;
}

bool rises_into(const IrMount& mount, const Obstacle& obstacle, double range_m) {
  return obstacle.height_m >= mount.height_m - range_m * std::tan(mount.half_angle_rad);
}

}  // namespace

double ray_range_m(WorldPoint from, WorldPoint direction, const Obstacle& obstacle) {
  if (distance_m(obstacle, from) <= 0.0) return 0.0;
  return std::min({to_disc_m(from, direction, obstacle.a, obstacle.radius_m),
                   to_disc_m(from, direction, obstacle.b, obstacle.radius_m),
                   to_side_m(from, direction, obstacle, obstacle.radius_m),
                   to_side_m(from, direction, obstacle, -obstacle.radius_m)});
}

double ir_range_m(const IrMount& mount, const PlanarPose& X_WB, std::span<const Obstacle> obstacles) {
  const WorldPoint from = X_WB.to_world({mount.x_m, mount.y_m});
  double nearest_m = mount.longest_m, echo_1pm2 = 0.0;
  for (int i = 0; i < kRays; ++i) {
    const double angle_rad = X_WB.heading_rad + mount.half_angle_rad * (2.0 * i / (kRays - 1) - 1.0);
    const WorldPoint direction{std::cos(angle_rad), std::sin(angle_rad)};
    double range_m = mount.longest_m;
    TruthLabel label = TruthLabel::sky;
    for (const Obstacle& obstacle : obstacles) {
      const double hit_m = ray_range_m(from, direction, obstacle);
      if (hit_m >= range_m || !rises_into(mount, obstacle, hit_m)) continue;
      range_m = hit_m;
      label = obstacle.label;
    }
    if (label == TruthLabel::sky) continue;
    nearest_m = std::min(nearest_m, range_m);
    echo_1pm2 += reflectivity(label) / (kRays * std::max(range_m * range_m, 1e-4));
  }
  return echo_1pm2 >= kLeastEcho_1pm2 ? nearest_m : mount.longest_m;
}

double ir_reading_m(const IrMount& mount, double range_m, Random& random) {
  if (range_m >= mount.longest_m) return mount.longest_m;
  const double sigma_m = kSigma_m + kSigmaOfRange * range_m;
  return std::clamp(range_m + sigma_m * random.normal(), 0.0, mount.longest_m);
}

}  // namespace hindsight
