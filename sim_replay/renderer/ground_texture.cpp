// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/ground_texture.h"

#include <algorithm>
#include <cmath>

#include "sim_replay/renderer/ground_recipes.h"
#include "sim_replay/renderer/tiled_noise.h"

namespace hindsight {
namespace {

constexpr int kSize_px = 1024;

GroundPatchwork bare_earth(const GroundRecipe& recipe, std::uint32_t seed) {
  GroundPatchwork ground{Texels(kSize_px, kSize_px), kGroundTile_m / kSize_px};
  for (int y = 0; y < kSize_px; ++y) {
    for (int x = 0; x < kSize_px; ++x) {
      const float u = static_cast<float>(x) / 64.0F, v = static_cast<float>(y) / 64.0F;
      const float lumps = tiled_fractal(u, v, kSize_px / 64, 6, seed);
      const float grain = tiled_fractal(u * 8.0F, v * 8.0F, kSize_px / 8, 3, seed + 9U) - 0.5F;
      const float tone = std::clamp(1.6F * lumps - 0.3F + 3.0F * recipe.grain * grain, 0.0F, 1.0F);
      ground.texels.at(x, y) = glm::vec4(glm::mix(recipe.dark, recipe.bright, tone),
                                         recipe.roughness_m * (lumps - 0.5F + 0.35F * recipe.grain * grain));
    }
  }
  return ground;
}

/// Mean height of the surroundings, by two passes of a box.
std::vector<float> smoothed_heights(const Texels& texels, int reach) {
  std::vector<float> rows(texels.rgba.size()), both(texels.rgba.size());
  const int n = texels.width;
  const auto at = [n](int x, int y) { return static_cast<std::size_t>((y & (n - 1)) * n + (x & (n - 1))); };
  for (int y = 0; y < n; ++y) {
    float sum = 0.0F;
    for (int x = -reach; x <= reach; ++x) sum += texels.wrapped(x, y).a;
    for (int x = 0; x < n; ++x) {
      rows[at(x, y)] = sum;
      sum += texels.wrapped(x + reach + 1, y).a - texels.wrapped(x - reach, y).a;
    }
  }
  const float share = 1.0F / static_cast<float>((2 * reach + 1) * (2 * reach + 1));
  for (int x = 0; x < n; ++x) {
    float sum = 0.0F;
    for (int y = -reach; y <= reach; ++y) sum += rows[at(x, y)];
    for (int y = 0; y < n; ++y) {
      both[at(x, y)] = sum * share;
      sum += rows[at(x, y + reach + 1)] - rows[at(x, y - reach)];
    }
  }
  return both;
}

/// Sunlight on a texel against level ground: by its slope, none where higher texels stand in the way.
float sunlight(const GroundPatchwork& ground, int x, int y, glm::vec3 to_sun) {
  const Texels& texels = ground.texels;
  const float rise_x = (texels.wrapped(x + 1, y).a - texels.wrapped(x - 1, y).a) / (2.0F * ground.texel_m);
  const float rise_y = (texels.wrapped(x, y + 1).a - texels.wrapped(x, y - 1).a) / (2.0F * ground.texel_m);
  const glm::vec3 normal = glm::normalize(glm::vec3(-0.6F * rise_x, -0.6F * rise_y, 1.0F));
  float light = std::max(0.0F, glm::dot(normal, to_sun)) / to_sun.z;
  const glm::vec2 across = glm::normalize(glm::vec2(to_sun));
  const float climb_m = to_sun.z / glm::length(glm::vec2(to_sun)) * ground.texel_m;
  for (const int step : {2, 4, 7, 11, 16}) {
    const float away = static_cast<float>(step);
    const float over_m =
        texels.wrapped(x + static_cast<int>(across.x * away), y + static_cast<int>(across.y * away)).a -
        texels.at(x, y).a - away * climb_m;
    if (over_m > 0.0F) light *= 1.0F - std::min(0.8F, over_m / 0.006F);
  }
  return light;
}

/// The light at all texels together is that of level ground: grain moves light about and makes none.
void keep_mean_light(Texels& texels) {
  float sum = 0.0F;
  for (const glm::vec4& texel : texels.rgba) sum += texel.a;
  const float gain = 0.5F * static_cast<float>(texels.rgba.size()) / sum;
  for (glm::vec4& texel : texels.rgba) texel.a = std::min(1.0F, texel.a * gain);
}

Texels lit(const GroundPatchwork& ground, glm::vec3 to_sun) {
  const std::vector<float> around_m = smoothed_heights(ground.texels, 8);
  Texels result(ground.texels.width, ground.texels.height);
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      const glm::vec4& texel = ground.texels.at(x, y);
      const float hollow_m = around_m[static_cast<std::size_t>(y * result.width + x)] - texel.a;
      const float open = std::clamp(1.0F - 45.0F * hollow_m, 0.22F, 1.25F);
      result.at(x, y) = glm::vec4(open * glm::vec3(texel), 0.5F * sunlight(ground, x, y, to_sun));
    }
  }
  keep_mean_light(result);
  return result;
}

}  // namespace

Texels ground_texture(Ground ground, glm::vec3 to_sun, std::uint64_t seed) {
  Random random(seed, static_cast<std::uint64_t>(ground));
  const GroundRecipe recipe = ground_recipe(ground);
  GroundPatchwork patchwork = bare_earth(recipe, static_cast<std::uint32_t>(random.next()));
  for (const Stamps& stamps : recipe.stamps) strew(patchwork, stamps, random);
  return lit(patchwork, to_sun);
}

GroundGloss ground_gloss(Ground ground) {
  switch (ground) {
    case Ground::grass:
      return {0.07F, 3.0F, 0.0F};
    case Ground::leaf_litter:
      return {0.08F, 4.0F, 0.0F};
    case Ground::soil:
      return {0.04F, 2.0F, 0.0F};
    case Ground::mulch:
      return {0.05F, 3.0F, 0.0F};
    case Ground::road:
      return {0.06F, 2.0F, 0.0F};
    case Ground::mud:
      return {0.3F, 40.0F, 0.25F};
    case Ground::gravel:
      return {0.05F, 2.0F, 0.0F};
  }
  return {};
}

GroundVariety ground_variety(Ground ground) {
  switch (ground) {
    case Ground::grass:
      return {{1.65F, 1.2F, 1.15F}, {0.62F, 0.78F, 0.66F}};
    case Ground::leaf_litter:
      return {{1.35F, 1.28F, 1.2F}, {0.5F, 0.52F, 0.55F}};
    case Ground::soil:
      return {{1.45F, 1.43F, 1.4F}, {0.52F, 0.5F, 0.48F}};
    case Ground::mulch:
      return {{1.3F, 1.35F, 1.35F}, {0.7F, 0.65F, 0.65F}};
    case Ground::road:
      return {{1.35F, 1.35F, 1.33F}, {0.62F, 0.6F, 0.58F}};
    case Ground::mud:
      return {{1.4F, 1.4F, 1.4F}, {0.7F, 0.7F, 0.7F}};
    case Ground::gravel:
      return {{1.4F, 1.37F, 1.32F}, {0.55F, 0.55F, 0.53F}};
  }
  return {};
}

}  // namespace hindsight
