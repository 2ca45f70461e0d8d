// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/world/lay_ground.h"

#include <cmath>
#include <numbers>

#include "sim_replay/world/random.h"
#include "sim_replay/world/random_streams.h"

namespace hindsight {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
/// The trail goes on behind start and goal, out of the camera's sight.
constexpr double kTrailGoesOn_m = 40.0;
/// A lane as steep as sqrt(6) north for each metre east still has points less than 1 m apart.
constexpr double kTrailStep_m = 0.35;

Terrain make_terrain(const TerrainParams& params, Random random) {
  Terrain terrain{params.slope_along, params.slope_across, {}};
  for (int i = 0; i < params.waves; ++i) {
    const double radpm = kTwoPi / random.uniform(params.wave_min_m, params.wave_max_m);
    const double direction_rad = random.uniform(0.0, kTwoPi);
    terrain.waves.push_back({radpm * std::cos(direction_rad), radpm * std::sin(direction_rad),
                             random.uniform(0.0, kTwoPi), params.wave_steepness / radpm});
  }
  if (params.dip_m > 0.0) {
    terrain.waves.push_back(
        {kTwoPi / params.dip_period_m, 0.0, random.uniform(0.0, kTwoPi), 0.5 * params.dip_m});
  }
  return terrain;
}

Trail make_trail(const Course& course, const Lane& lane) {
  Trail trail{{}, course.trail.width_m, course.trail.edge_m, ground_of(course.trail.ground)};
  const double end_m = course.course.length_m + kTrailGoesOn_m;
  for (double x_m = -kTrailGoesOn_m; x_m <= end_m; x_m += kTrailStep_m) {
    trail.centre.push_back(lane.at(x_m, 0.0));
  }
  return trail;
}

/// One patch in each part of the way, so that they do not all lie in one place.
std::vector<GroundSpot> make_mud(const MudParams& params, const Lane& lane, Random random) {
  std::vector<GroundSpot> patches;
  const double part_m = (params.to_m - params.from_m) / params.patches;
  for (int i = 0; i < params.patches; ++i) {
    const double x_m = params.from_m + part_m * (i + random.uniform(0.0, 1.0));
    const WorldPoint at = lane.at(x_m, random.uniform(-params.aside_m, params.aside_m));
    patches.push_back({at, random.uniform(params.radius_min_m, params.radius_max_m), Ground::mud});
  }
  return patches;
}

}  // namespace

void lay_ground(const Course& course, const Lane& lane, std::uint64_t seed, World& world) {
  world.ground = ground_of(course.course.ground);
  world.terrain = make_terrain(course.terrain, Random(seed, terrain_stream));
  if (course.trail.width_m > 0.0) world.trails.push_back(make_trail(course, lane));
  if (course.mud.patches > 0) world.patches = make_mud(course.mud, lane, Random(seed, mud_stream));
}

}  // namespace hindsight
