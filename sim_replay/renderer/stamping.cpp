// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/stamping.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hindsight {
namespace {

struct Placed {
  glm::vec2 middle_px;
  glm::vec2 along;  ///< unit vector of its length
  float half_length_px, half_width_px;
  float foot_m, rise_m;
  glm::vec3 albedo;
};

float uniform(Random& random, float low, float high) {
  return static_cast<float>(random.uniform(static_cast<double>(low), static_cast<double>(high)));
}

/// Half width at u (-1 to 1 along its length), as a share of the largest.
float outline(StampShape shape, float u) {
  switch (shape) {
    case StampShape::blade:
      return 0.5F * (1.0F - u);
    case StampShape::leaf:
      return 1.0F - u * u;
    case StampShape::chip:
      return 1.0F;
    case StampShape::pebble:
      return std::sqrt(std::max(0.0F, 1.0F - u * u));
  }
  return 0.0F;
}

/// How far above its foot, as a share of its rise, at u along and v across (-1 to 1).
float relief(StampShape shape, float u, float v) {
  switch (shape) {
    case StampShape::blade:
      return 0.5F + 0.5F * u;  // its tip stands up
    case StampShape::leaf:
      return 0.6F + 0.4F * u * u - 0.3F * v;  // curls and lies askew
    case StampShape::chip:
      return 0.8F - 0.2F * std::abs(v) + 0.3F * u;
    case StampShape::pebble:
      return std::sqrt(std::max(0.0F, 1.0F - v * v)) * outline(shape, u);
  }
  return 0.0F;
}

glm::vec3 shade_across(StampShape shape, float v) {
  if (shape == StampShape::leaf && std::abs(v) < 0.12F) return glm::vec3(0.75F);  // the midrib
  if (shape == StampShape::blade) return glm::vec3(0.85F + 0.3F * std::abs(v));
  return glm::vec3(1.0F);
}

void lay(GroundPatchwork& ground, StampShape shape, const Placed& one) {
  const int reach = static_cast<int>(std::ceil(std::max(one.half_length_px, one.half_width_px)));
  const int x0 = static_cast<int>(one.middle_px.x), y0 = static_cast<int>(one.middle_px.y);
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const glm::vec2 offset(static_cast<float>(x), static_cast<float>(y));
      const float u = glm::dot(offset, one.along) / one.half_length_px;
      if (std::abs(u) > 1.0F) continue;
      const float half_width_px = std::max(0.6F, one.half_width_px * outline(shape, u));
      const float v = (offset.y * one.along.x - offset.x * one.along.y) / half_width_px;
      if (std::abs(v) > 1.0F) continue;
      const float height_m = one.foot_m + one.rise_m * relief(shape, u, v);
      glm::vec4& texel = ground.texels.wrapped(x0 + x, y0 + y);
      if (height_m > texel.a) texel = glm::vec4(one.albedo * shade_across(shape, v), height_m);
    }
  }
}

Placed placed(const GroundPatchwork& ground, const Stamps& stamps, Random& random) {
  const float length_m = uniform(random, stamps.length_min_m, stamps.length_max_m);
  const float angle = uniform(random, 0.0F, 2.0F * std::numbers::pi_v<float>);
  const float size = static_cast<float>(ground.texels.width);
  Placed one;
  one.middle_px = {uniform(random, 0.0F, size), uniform(random, 0.0F, size)};
  one.along = {std::cos(angle), std::sin(angle)};
  one.half_length_px = 0.5F * length_m / ground.texel_m;
  one.half_width_px = one.half_length_px / (stamps.slenderness * uniform(random, 0.75F, 1.35F));
  one.foot_m = uniform(random, 0.0F, stamps.lift_m);
  one.rise_m = stamps.shape == StampShape::pebble ? 0.22F * length_m : 0.3F * stamps.lift_m;
  const float tone = 1.0F + stamps.tone_spread * uniform(random, -1.0F, 1.0F);
  one.albedo = tone * stamps.albedos[random.next() % stamps.albedos.size()];
  return one;
}

float linear(int srgb) {
  const float value = static_cast<float>(srgb) / 255.0F;
  return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

}  // namespace

void strew(GroundPatchwork& ground, const Stamps& stamps, Random& random) {
  for (int i = 0; i < stamps.count; ++i) lay(ground, stamps.shape, placed(ground, stamps, random));
}

glm::vec3 albedo(int red, int green, int blue) { return {linear(red), linear(green), linear(blue)}; }

}  // namespace hindsight
