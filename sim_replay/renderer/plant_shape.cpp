// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/plant_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim_replay/renderer/object_texture.h"
#include "sim_replay/world/random.h"

namespace hindsight {
namespace {

constexpr int kTreeCards = 150;
constexpr int kBushCards = 60;

class Dice {
 public:
  explicit Dice(std::uint32_t look) : random_(look, 21) {}
  float operator()(float low, float high) {
    return static_cast<float>(random_.uniform(static_cast<double>(low), static_cast<double>(high)));
  }
  int pick(int n) { return static_cast<int>(random_.next() % static_cast<std::uint64_t>(n)); }
  glm::vec3 direction() {
    const float z = (*this)(-1.0F, 1.0F), angle = (*this)(0.0F, 2.0F * std::numbers::pi_v<float>);
    const float r = std::sqrt(1.0F - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  glm::vec3 tint(float spread) {
    const float tone = (*this)(1.0F - spread, 1.0F + spread);
    return tone * glm::vec3((*this)(1.0F - 0.4F * spread, 1.0F + 0.4F * spread), 1.0F,
                            (*this)(1.0F - 0.4F * spread, 1.0F));
  }

 private:
  Random random_;
};

glm::vec3 foot(WorldPoint at, const Terrain& terrain) {
  return {static_cast<float>(at.x_m), static_cast<float>(at.y_m), static_cast<float>(terrain.height_m(at))};
}

LeafCard card(Dice& dice, glm::vec3 middle, float half_m) {
  const glm::vec3 u = dice.direction();
  const glm::vec3 v = glm::normalize(glm::cross(u, dice.direction()) + glm::vec3(1e-4F));
  return {middle, half_m * u, half_m * v};
}

/// Cards in clumps near the surface of the ellipsoid, none below the lowest height.
void grow_leaves(PlantShape& plant, Dice& dice, int cards, int clumps, float half_m, float lowest_m) {
  std::vector<glm::vec3> clump_middles;
  for (int i = 0; i < clumps; ++i) {
    clump_middles.push_back(plant.crown_middle +
                            plant.crown_radii * dice.direction() * std::cbrt(dice(0.2F, 0.9F)));
  }
  while (static_cast<int>(plant.cards.size()) < cards) {
    const glm::vec3 clump = clump_middles[static_cast<std::size_t>(dice.pick(clumps))];
    glm::vec3 p = clump + 0.36F * plant.crown_radii * dice.direction() * dice(0.3F, 1.0F);
    const float half = half_m * dice(0.7F, 1.2F);
    p.z = std::max(p.z, lowest_m + 0.6F * half);
    plant.cards.push_back(card(dice, p, half));
  }
}

float trunk_radius_m(const Tree& tree, float height_m) {
  const auto radius_m = static_cast<float>(tree.radius_m), top_m = static_cast<float>(tree.height_m);
  const float flare = 0.45F * std::exp(-height_m / 0.12F);
  return radius_m * (1.0F + flare) * std::max(0.1F, 1.0F - 0.9F * height_m / top_m);
}

void grow_trunk(PlantShape& plant, const Tree& tree, glm::vec3 base, Dice& dice) {
  const auto top_m = static_cast<float>(tree.height_m) * 0.9F;
  const glm::vec2 lean(dice(-0.04F, 0.04F), dice(-0.04F, 0.04F)),
      bow(dice(-0.012F, 0.012F), dice(-0.012F, 0.012F));
  const auto middle = [&](float z) {
    return base + glm::vec3(lean * std::max(0.0F, z - 0.5F) + bow * z * z * 0.5F, z);
  };
  float from_m = -0.15F;
  for (const float to_m : {0.1F, 0.3F, 0.55F, 0.85F, 1.2F, 1.6F, 2.1F, 2.8F, 0.7F * top_m, top_m}) {
    if (to_m <= from_m) continue;
    plant.limbs.push_back({middle(from_m), middle(to_m), trunk_radius_m(tree, std::max(0.0F, from_m)),
                           trunk_radius_m(tree, to_m)});
    from_m = to_m;
  }
  plant.trunk_limbs = static_cast<int>(plant.limbs.size());
}

glm::vec3 on_trunk(const PlantShape& plant, float z) {
  for (int i = 0; i < plant.trunk_limbs; ++i) {
    const Limb& limb = plant.limbs[static_cast<std::size_t>(i)];
    if (z <= limb.to.z) return glm::mix(limb.from, limb.to, (z - limb.from.z) / (limb.to.z - limb.from.z));
  }
  return plant.limbs[static_cast<std::size_t>(plant.trunk_limbs - 1)].to;
}

void grow_branches(PlantShape& plant, const Tree& tree, float base_z, Dice& dice) {
  const auto low_m = static_cast<float>(tree.crown_base_m), top_m = static_cast<float>(tree.height_m);
  const auto reach_m = static_cast<float>(tree.crown_radius_m);
  for (int i = 0; i < 9; ++i) {
    const float z = dice(0.75F * low_m, 0.8F * top_m), angle = dice(0.0F, 6.28F);
    const glm::vec3 from = on_trunk(plant, base_z + z);
    const float out_m = reach_m * dice(0.4F, 0.9F);
    const glm::vec3 to =
        from + glm::vec3(out_m * std::cos(angle), out_m * std::sin(angle), out_m * dice(0.1F, 0.8F));
    const float radius_m = 0.35F * trunk_radius_m(tree, z);
    plant.limbs.push_back({from, to, radius_m, 0.25F * radius_m});
  }
}

}  // namespace

float PlantShape::light_through(glm::vec3 p, glm::vec3 to_light) const {
  const glm::vec3 q = (p - crown_middle) / crown_radii, d = to_light / crown_radii;
  const float a = glm::dot(d, d), b = glm::dot(q, d), c = glm::dot(q, q) - 1.0F;
  const float inside = b * b - a * c;
  if (inside <= 0.0F) return 1.0F;
  const float far = (-b + std::sqrt(inside)) / a, near = std::max(0.0F, (-b - std::sqrt(inside)) / a);
  if (far <= near) return 1.0F;
  const float mean_radius_m = std::cbrt(crown_radii.x * crown_radii.y * crown_radii.z);
  return std::exp(-1.7F * (far - near) / mean_radius_m);
}

PlantShape shape_of(const Tree& tree, const Terrain& terrain) {
  Dice dice(tree.look);
  PlantShape plant;
  const glm::vec3 base = foot(tree.at, terrain);
  const auto low_m = static_cast<float>(tree.crown_base_m), top_m = static_cast<float>(tree.height_m);
  const auto reach_m = static_cast<float>(tree.crown_radius_m);
  plant.bark = static_cast<std::uint16_t>(furrowed_bark + dice.pick(kBarkLayers));
  plant.leaves = dice(0.0F, 1.0F) < 0.75F ? green_leaves : yellow_leaves;
  plant.bark_tint = dice.tint(0.3F);
  plant.leaf_tint = dice.tint(0.25F);
  grow_trunk(plant, tree, base, dice);
  grow_branches(plant, tree, base.z, dice);
  plant.crown_radii = {reach_m, reach_m, 0.5F * (top_m - low_m)};
  plant.crown_middle = on_trunk(plant, base.z + 0.5F * (low_m + top_m));
  grow_leaves(plant, dice, kTreeCards, 12, 0.32F * std::sqrt(reach_m), base.z + low_m * 0.8F);
  return plant;
}

PlantShape shape_of(const Bush& bush, const Terrain& terrain) {
  Dice dice(bush.look);
  PlantShape plant;
  const glm::vec3 base = foot(bush.at, terrain);
  const auto reach_m = static_cast<float>(bush.radius_m), top_m = static_cast<float>(bush.height_m);
  const float kind = dice(0.0F, 1.0F);
  plant.bark = grey_bark;
  plant.leaves = bush.drivable || kind > 0.7F ? dry_leaves : kind > 0.5F ? yellow_leaves : green_leaves;
  plant.leaf_tint = dice.tint(0.25F);
  plant.bark_tint = dice.tint(0.3F);
  plant.crown_radii = {0.85F * reach_m, 0.85F * reach_m, 0.55F * top_m};
  plant.crown_middle = base + glm::vec3(0.0F, 0.0F, 0.5F * top_m);
  grow_leaves(plant, dice, bush.drivable ? kBushCards / 2 : kBushCards, 8, 0.24F * std::sqrt(reach_m),
              base.z);
  for (int i = 0; i < 6; ++i) {
    const LeafCard& end = plant.cards[static_cast<std::size_t>(i)];
    plant.limbs.push_back({base - glm::vec3(0.0F, 0.0F, 0.05F), end.middle, 0.012F, 0.004F});
  }
  return plant;
}

}  // namespace hindsight
