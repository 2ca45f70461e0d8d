// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/ground_shadows.h"

#include <algorithm>
#include <cmath>

#include "sim_replay/renderer/plant_shape.h"

namespace hindsight {
namespace {

/// The sun is half a degree wide.
constexpr float kPenumbra = 0.0093F;
/// Share of a card that is leaves.
constexpr float kLeafShare = 0.55F;

float step(float inside_m, float soft_m) {
  const float t = std::clamp(0.5F + inside_m / soft_m, 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

class Shadows {
 public:
  Shadows(GroundMask& mask, glm::vec3 to_sun)
      : mask_(mask), per_m_(-glm::vec2(to_sun) / to_sun.z), slant_(1.0F / to_sun.z) {}

  /// Where the shadow of a point falls, around a foot at which the ground has its height.
  glm::vec2 of(glm::vec3 p, float ground_z) const {
    return glm::vec2(p) + per_m_ * std::max(0.0F, p.z - ground_z);
  }

  /// A tapered stripe.
  void limb(const Limb& limb, float ground_z, float least_m) {
    const glm::vec2 a = of(limb.from, ground_z), b = of(limb.to, ground_z);
    const float reach_m = std::max({limb.radius_from_m, limb.radius_to_m, least_m}) + 0.3F;
    each(a, b, reach_m, [&](glm::vec2 p, glm::vec4& light) {
      const float share = along(a, b, p);
      const float high_m = std::max(0.0F, glm::mix(limb.from.z, limb.to.z, share) - ground_z);
      const float radius_m = glm::mix(limb.radius_from_m, limb.radius_to_m, share);
      const float soft_m = std::max(0.05F, kPenumbra * high_m * slant_);
      const float covered = step(radius_m - glm::distance(p, glm::mix(a, b, share)), soft_m);
      // Thinner than the sun's image: darkens it in part only.
      light.r = std::min(light.r, 1.0F - covered * std::min(1.0F, 2.5F * radius_m / soft_m));
    });
  }

  void card(const LeafCard& card, float ground_z, bool crown) {
    const glm::vec2 middle = of(card.middle, ground_z);
    const float radius_m = 0.75F * glm::length(card.half_u);
    const float soft_m = std::max(0.12F, kPenumbra * (card.middle.z - ground_z) * slant_ + 0.08F);
    each(middle, middle, radius_m + soft_m, [&](glm::vec2 p, glm::vec4& light) {
      const float left = 1.0F - kLeafShare * step(radius_m - glm::distance(p, middle), soft_m);
      light.r *= left;
      if (crown) light.b *= left;
    });
  }

  /// Sky hidden by something wide above or beside.
  void canopy(glm::vec2 middle, float radius_m, float depth) {
    each(middle, middle, 2.0F * radius_m, [&](glm::vec2 p, glm::vec4& light) {
      const float away = glm::distance(p, middle) / radius_m;
      light.g *= 1.0F - depth * std::exp(-away * away);
    });
  }

  void foot(glm::vec2 middle, float radius_m, float width_m, float depth) {
    each(middle, middle, radius_m + 4.0F * width_m, [&](glm::vec2 p, glm::vec4& light) {
      const float away_m = std::max(0.0F, glm::distance(p, middle) - radius_m);
      light.g *= 1.0F - depth * std::exp(-away_m / width_m);
    });
  }

 private:
  static float along(glm::vec2 a, glm::vec2 b, glm::vec2 p) {
    const float length2 = glm::dot(b - a, b - a);
    return length2 > 1e-8F ? std::clamp(glm::dot(p - a, b - a) / length2, 0.0F, 1.0F) : 0.0F;
  }

  template <typename Act>
  void each(glm::vec2 a, glm::vec2 b, float reach_m, Act act) {
    const auto world_point = [](glm::vec2 p) {
      return WorldPoint{static_cast<double>(p.x), static_cast<double>(p.y)};
    };
    const MaskArea area = area_around(mask_, world_point(a), world_point(b), static_cast<double>(reach_m));
    for (int y = area.y0; y <= area.y1; ++y) {
      for (int x = area.x0; x <= area.x1; ++x) {
        const glm::vec2 p = place_of(mask_, x, y);
        if (glm::distance(p, glm::mix(a, b, along(a, b, p))) < reach_m) act(p, mask_.light.at(x, y));
      }
    }
  }

  GroundMask& mask_;
  glm::vec2 per_m_;
  float slant_;
};

glm::vec2 ground_point(WorldPoint p) { return {p.x_m, p.y_m}; }

void cast(Shadows& shadows, const PlantShape& plant, float ground_z, bool crown) {
  for (const LeafCard& card : plant.cards) shadows.card(card, ground_z, crown);
  for (const Limb& limb : plant.limbs) shadows.limb(limb, ground_z, 0.02F);
}

}  // namespace

glm::vec2 place_of(const GroundMask& mask, int x, int y) {
  const glm::vec2 share((static_cast<float>(x) + 0.5F) / static_cast<float>(mask.light.width),
                        (static_cast<float>(y) + 0.5F) / static_cast<float>(mask.light.height));
  return mask.corner_m + share * mask.size_m;
}

MaskArea area_around(const GroundMask& mask, WorldPoint a, WorldPoint b, double reach_m) {
  const glm::vec2 low(std::min(a.x_m, b.x_m) - reach_m, std::min(a.y_m, b.y_m) - reach_m);
  const glm::vec2 high(std::max(a.x_m, b.x_m) + reach_m, std::max(a.y_m, b.y_m) + reach_m);
  const glm::vec2 per_m = glm::vec2(mask.light.width, mask.light.height) / mask.size_m;
  const glm::vec2 from = (low - mask.corner_m) * per_m, to = (high - mask.corner_m) * per_m;
  return {std::max(0, static_cast<int>(from.x)), std::max(0, static_cast<int>(from.y)),
          std::min(mask.light.width - 1, static_cast<int>(to.x)),
          std::min(mask.light.height - 1, static_cast<int>(to.y))};
}

void cast_shadows(GroundMask& mask, const World& world, glm::vec3 to_sun) {
  Shadows shadows(mask, to_sun);
  const auto height = [&](WorldPoint p) { return static_cast<float>(world.terrain.height_m(p)); };
  for (const Tree& tree : world.trees) {
    cast(shadows, shape_of(tree, world.terrain), height(tree.at), true);
    shadows.canopy(ground_point(tree.at), 1.5F * static_cast<float>(tree.crown_radius_m), 0.3F);
    shadows.foot(ground_point(tree.at), static_cast<float>(tree.radius_m), 0.12F, 0.65F);
  }
  for (const Bush& bush : world.bushes) {
    cast(shadows, shape_of(bush, world.terrain), height(bush.at), false);
    shadows.foot(ground_point(bush.at), 0.8F * static_cast<float>(bush.radius_m), 0.15F, 0.6F);
  }
  for (const Rock& rock : world.rocks) {
    const glm::vec3 base(rock.at.x_m, rock.at.y_m, height(rock.at));
    const auto radius_m = static_cast<float>(rock.radius_m), height_m = static_cast<float>(rock.height_m);
    shadows.limb({base, base + glm::vec3(0.0F, 0.0F, 0.8F * height_m), 0.9F * radius_m, 0.4F * radius_m},
                 base.z, radius_m);
    shadows.foot(ground_point(rock.at), radius_m, 0.1F, 0.6F);
  }
  for (const Fence& fence : world.fences) {
    for (const WorldPoint& p : fence.posts) {
      const glm::vec3 base(p.x_m, p.y_m, height(p));
      shadows.limb({base, base + glm::vec3(0.0F, 0.0F, static_cast<float>(fence.height_m)), 0.03F, 0.03F},
                   base.z, 0.03F);
      shadows.foot(ground_point(p), 0.03F, 0.05F, 0.5F);
    }
  }
}

}  // namespace hindsight
