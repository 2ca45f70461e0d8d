// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/world/world.h"

#include <algorithm>
#include <cmath>

#include "sim_replay/world/obstacle.h"

namespace hindsight {
namespace {

/// Edges of trails are decided at half their fading, which lies about half the width.
bool lies_on(const Trail& trail, WorldPoint p) {
  const double reach_m = 0.5 * trail.width_m;
  for (std::size_t i = 1; i < trail.centre.size(); ++i) {
    const WorldPoint &a = trail.centre[i - 1], &b = trail.centre[i];
    // Most of a long trail is far away: no root for that.
    if (std::min(a.x_m, b.x_m) - reach_m > p.x_m || std::max(a.x_m, b.x_m) + reach_m < p.x_m) continue;
    const WorldPoint nearest = nearest_on_segment(a, b, p);
    if (std::hypot(p.x_m - nearest.x_m, p.y_m - nearest.y_m) <= reach_m) return true;
  }
  return false;
}

}  // namespace

double Terrain::height_m(WorldPoint p) const {
  double height_m = slope_x * p.x_m + slope_y * p.y_m;
  for (const Wave& wave : waves) {
    height_m += wave.amplitude_m * std::sin(wave.kx_radpm * p.x_m + wave.ky_radpm * p.y_m + wave.phase_rad);
  }
  return height_m;
}

WorldPoint Terrain::gradient(WorldPoint p) const {
  WorldPoint rise{slope_x, slope_y};
  for (const Wave& wave : waves) {
    const double steepest =
        wave.amplitude_m * std::cos(wave.kx_radpm * p.x_m + wave.ky_radpm * p.y_m + wave.phase_rad);
    rise.x_m += steepest * wave.kx_radpm;
    rise.y_m += steepest * wave.ky_radpm;
  }
  return rise;
}

Ground World::ground_at(WorldPoint p) const {
  for (auto patch = patches.rbegin(); patch != patches.rend(); ++patch) {
    if (std::hypot(p.x_m - patch->at.x_m, p.y_m - patch->at.y_m) <= patch->radius_m) return patch->ground;
  }
  for (auto trail = trails.rbegin(); trail != trails.rend(); ++trail) {
    if (lies_on(*trail, p)) return trail->ground;
  }
  return ground;
}

}  // namespace hindsight
