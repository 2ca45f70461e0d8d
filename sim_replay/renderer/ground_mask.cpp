// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/ground_mask.h"

#include <algorithm>
#include <cmath>

#include "sim_replay/renderer/ground_shadows.h"
#include "sim_replay/renderer/tiled_noise.h"
#include "sim_replay/world/obstacle.h"

namespace hindsight {
namespace {

constexpr float kMargin_m = 8.0F;
constexpr float kMostTexels = 3.0e6F;

struct Box {
  glm::vec2 low, high;

  void take(WorldPoint p) {
    low = glm::min(low, glm::vec2(p.x_m, p.y_m));
    high = glm::max(high, glm::vec2(p.x_m, p.y_m));
  }
};

Box box_of(const World& world) {
  Box box{glm::vec2(world.start.x_m, world.start.y_m), glm::vec2(world.start.x_m, world.start.y_m)};
  box.take(world.goal);
  for (const Obstacle& obstacle : obstacles_of(world)) {
    box.take(obstacle.a);
    box.take(obstacle.b);
  }
  for (const Trail& trail : world.trails) {
    for (const WorldPoint& p : trail.centre) box.take(p);
  }
  return {box.low - kMargin_m, box.high + kMargin_m};
}

GroundMask empty_mask(const World& world) {
  const Box box = box_of(world);
  const glm::vec2 size_m = box.high - box.low;
  const float texel_m = std::max(0.05F, std::sqrt(size_m.x * size_m.y / kMostTexels));
  const int width = static_cast<int>(size_m.x / texel_m) + 1,
            height = static_cast<int>(size_m.y / texel_m) + 1;
  return {box.low, size_m, Texels(width, height, glm::vec4(1.0F, 1.0F, 1.0F, 0.5F)),
          Texels(width, height, glm::vec4(0.0F, 0.0F, 0.5F, 0.0F))};
}

/// Ground is lighter and drier here than there, from decimetres to tens of metres.
void vary(GroundMask& mask, std::uint32_t seed) {
  const float texel_m = mask.size_m.x / static_cast<float>(mask.light.width);
  for (int y = 0; y < mask.light.height; ++y) {
    for (int x = 0; x < mask.light.width; ++x) {
      const float u = static_cast<float>(x) * texel_m, v = static_cast<float>(y) * texel_m;
      const float fine = tiled_fractal(u * 2.3F, v * 2.3F, 4096, 4, seed);
      const float coarse = tiled_fractal(u / 9.0F, v / 9.0F, 4096, 3, seed + 7U);
      mask.light.at(x, y).a = 0.5F + 1.25F * (fine - 0.5F) + 0.8F * (coarse - 0.5F);
      const float patches = tiled_fractal(u / 3.0F, v / 3.0F, 4096, 6, seed + 13U);
      mask.kinds.at(x, y).b = std::clamp(0.5F + 2.6F * (patches - 0.5F), 0.0F, 1.0F);
    }
  }
}

float fade(float inside_m, float edge_m) {
  const float t = std::clamp(0.5F + inside_m / std::max(0.02F, edge_m), 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

/// An edge is ragged by as much as it fades.
float ragged_m(const GroundMask& mask, int x, int y, float edge_m) {
  const float texel_m = mask.size_m.x / static_cast<float>(mask.kinds.width);
  const float grain = tiled_fractal(static_cast<float>(x) * texel_m * 3.0F,
                                    static_cast<float>(y) * texel_m * 3.0F, 4096, 4, 99U);
  return 1.6F * edge_m * (grain - 0.5F);
}

/// Calls with each texel within reach of a segment and its distance from it.
template <typename Act>
void around(GroundMask& mask, WorldPoint a, WorldPoint b, double reach_m, Act act) {
  const MaskArea area = area_around(mask, a, b, reach_m);
  for (int y = area.y0; y <= area.y1; ++y) {
    for (int x = area.x0; x <= area.x1; ++x) {
      const glm::vec2 p = place_of(mask, x, y);
      const WorldPoint here{static_cast<double>(p.x), static_cast<double>(p.y)};
      const WorldPoint near = nearest_on_segment(a, b, here);
      act(x, y, static_cast<float>(std::hypot(here.x_m - near.x_m, here.y_m - near.y_m)));
    }
  }
}

/// Wheels leave two dry, light tracks where the ground is bare.
bool keeps_tracks(Ground ground) {
  return ground == Ground::soil || ground == Ground::road || ground == Ground::gravel;
}

void wear(GroundMask& mask, int x, int y, float away_m, float half_m) {
  const float off = (away_m - 0.45F * half_m) / (0.22F * half_m);
  const float track = std::exp(-off * off);
  mask.light.at(x, y).a += 0.16F * track;
  mask.kinds.at(x, y).b = std::clamp(mask.kinds.at(x, y).b + 0.3F * track - 0.1F, 0.0F, 1.0F);
}

std::vector<float> distances_m(GroundMask& mask, const Trail& trail) {
  std::vector<float> nearest(mask.kinds.rgba.size(), 1e9F);
  for (std::size_t i = 1; i < trail.centre.size(); ++i) {
    around(mask, trail.centre[i - 1], trail.centre[i], 0.5 * trail.width_m + 2.0 * trail.edge_m,
           [&](int x, int y, float away_m) {
             float& least = nearest[static_cast<std::size_t>(y * mask.kinds.width + x)];
             least = std::min(least, away_m);
           });
  }
  return nearest;
}

void lay_trail(GroundMask& mask, const Trail& trail) {
  const auto half_m = static_cast<float>(0.5 * trail.width_m), edge_m = static_cast<float>(trail.edge_m);
  mask.trail = trail.ground;
  const std::vector<float> away_m = distances_m(mask, trail);
  for (int y = 0; y < mask.kinds.height; ++y) {
    for (int x = 0; x < mask.kinds.width; ++x) {
      const float away = away_m[static_cast<std::size_t>(y * mask.kinds.width + x)];
      if (away > 1e8F) continue;
      float& share = mask.kinds.at(x, y).r;
      share = std::max(share, fade(half_m - away + ragged_m(mask, x, y, edge_m), edge_m));
      if (keeps_tracks(trail.ground)) wear(mask, x, y, away, half_m);
    }
  }
}

void lay_patch(GroundMask& mask, const GroundSpot& patch) {
  mask.patch = patch.ground;
  const auto radius_m = static_cast<float>(patch.radius_m);
  around(mask, patch.at, patch.at, patch.radius_m + 0.6, [&](int x, int y, float away_m) {
    float& share = mask.kinds.at(x, y).g;
    share = std::max(share, fade(radius_m - away_m + ragged_m(mask, x, y, 0.3F), 0.3F));
  });
}

}  // namespace

GroundMask ground_mask(const World& world, glm::vec3 to_sun) {
  GroundMask mask = empty_mask(world);
  vary(mask, static_cast<std::uint32_t>(world.seed));
  for (const Trail& trail : world.trails) lay_trail(mask, trail);
  for (const GroundSpot& patch : world.patches) lay_patch(mask, patch);
  cast_shadows(mask, world, to_sun);
  return mask;
}

}  // namespace hindsight
