// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/object_texture.h"

#include <algorithm>
#include <cmath>

#include "sim_replay/renderer/stamping.h"
#include "sim_replay/renderer/tiled_noise.h"

namespace hindsight {
namespace {

constexpr int kSize_px = 512;

struct Bark {
  glm::vec3 dark, bright;
  float furrows;  ///< how many round the trunk
  float stretch;  ///< how much longer than wide its plates are
  float lichen;   ///< share of the trunk
};

glm::vec3 bark_at(const Bark& bark, float u, float v, std::uint32_t seed) {
  const float bend = tiled_fractal(u * 8.0F, v * 8.0F, 8, 3, seed + 1U) - 0.5F;
  const int rows = std::max(1, static_cast<int>(bark.furrows / bark.stretch));
  const float plates =
      tiled_fractal(u * bark.furrows + 1.2F * bend, v * static_cast<float>(rows), rows, 2, seed);
  const float cracks = tiled_fractal(u * 4.0F * bark.furrows + 2.0F * bend, v * bark.furrows,
                                     static_cast<int>(bark.furrows), 2, seed + 4U);
  const float furrow = std::clamp(5.0F * std::abs(2.0F * plates - 1.0F), 0.0F, 1.0F);
  const float crack = std::clamp(4.0F * std::abs(2.0F * cracks - 1.0F), 0.0F, 1.0F);
  const float fine = tiled_noise(u * 128.0F, v * 64.0F, 64, seed + 2U) - 0.5F;
  const float broad = tiled_fractal(u * 4.0F, v * 4.0F, 4, 3, seed + 5U) - 0.5F;
  const float tone = std::clamp(furrow * (0.45F + 0.4F * crack) + 0.3F * fine + 0.6F * broad, 0.0F, 1.0F);
  const float spots = tiled_fractal(u * 8.0F, v * 8.0F, 8, 5, seed + 3U);
  const float lichen = std::clamp((spots - 1.0F + bark.lichen) * 6.0F, 0.0F, 0.6F);
  return glm::mix(glm::mix(bark.dark, bark.bright, tone), albedo(118, 122, 104), lichen);
}

Texels bark_texture(const Bark& bark, std::uint32_t seed) {
  Texels texels(kSize_px, kSize_px);
  for (int y = 0; y < kSize_px; ++y) {
    for (int x = 0; x < kSize_px; ++x) {
      const float u = static_cast<float>(x) / kSize_px, v = static_cast<float>(y) / kSize_px;
      texels.at(x, y) = glm::vec4(bark_at(bark, u, v, seed), 1.0F);
    }
  }
  return texels;
}

Texels mottled(glm::vec3 dark, glm::vec3 bright, std::uint32_t seed) {
  Texels texels(kSize_px, kSize_px);
  for (int y = 0; y < kSize_px; ++y) {
    for (int x = 0; x < kSize_px; ++x) {
      const float u = static_cast<float>(x) / 64.0F, v = static_cast<float>(y) / 64.0F;
      const float tone = std::clamp(2.0F * tiled_fractal(u, v, 8, 5, seed) - 0.5F, 0.0F, 1.0F);
      texels.at(x, y) = glm::vec4(glm::mix(dark, bright, tone), 1.0F);
    }
  }
  return texels;
}

/// A twig's worth of leaves on nothing.
Texels leaf_texture(const std::vector<glm::vec3>& albedos, int count, float slenderness, std::uint64_t seed) {
  GroundPatchwork twig{Texels(kSize_px, kSize_px, glm::vec4(0.0F, 0.0F, 0.0F, -1.0F)), 0.6F / kSize_px};
  Random random(seed, 77);
  strew(twig, {StampShape::chip, 8, 0.2F, 0.5F, 60.0F, 0.004F, {albedo(78, 66, 52)}, 0.2F}, random);
  strew(twig, {StampShape::leaf, count, 0.045F, 0.1F, slenderness, 0.08F, albedos, 0.35F}, random);
  glm::vec3 mean(0.0F);
  for (const glm::vec3& one : albedos) mean += one / static_cast<float>(albedos.size());
  for (glm::vec4& texel : twig.texels.rgba) {
    // Lower leaves are in the shade of higher ones. Empty texels have the leaves' mean, for the smaller
    // versions.
    const float open = 0.25F + 0.75F * std::clamp(texel.a / 0.08F, 0.0F, 1.0F);
    texel = texel.a < 0.0F ? glm::vec4(0.7F * mean, 0.0F) : glm::vec4(open * glm::vec3(texel), 1.0F);
  }
  return twig.texels;
}

}  // namespace

std::vector<Texels> object_textures(std::uint64_t seed) {
  const auto s = static_cast<std::uint32_t>(seed);
  return {
      bark_texture({albedo(46, 38, 32), albedo(104, 90, 76), 16.0F, 4.0F, 0.35F}, s + 1U),
      bark_texture({albedo(86, 80, 72), albedo(128, 121, 110), 8.0F, 1.0F, 0.45F}, s + 2U),
      bark_texture({albedo(64, 46, 36), albedo(118, 92, 72), 8.0F, 2.0F, 0.25F}, s + 3U),
      mottled(albedo(96, 90, 80), albedo(150, 142, 130), s + 4U),
      mottled(albedo(222, 88, 26), albedo(232, 98, 34), s + 5U),
      leaf_texture({albedo(66, 88, 36), albedo(84, 104, 44), albedo(54, 76, 34), albedo(98, 112, 54)}, 90,
                   1.9F, seed + 6U),
      leaf_texture({albedo(116, 116, 48), albedo(140, 120, 52), albedo(92, 104, 44)}, 80, 1.8F, seed + 7U),
      leaf_texture({albedo(118, 100, 68), albedo(98, 100, 62), albedo(136, 120, 86)}, 110, 4.0F, seed + 8U),
  };
}

}  // namespace hindsight
