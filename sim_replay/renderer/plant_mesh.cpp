// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim_replay/renderer/mesh_builder.h"
#include "sim_replay/renderer/plant_shape.h"

namespace hindsight {
namespace {

/// Of the cards, how many each level draws, and how much larger: they overlap less, and so cover about the
/// same.
constexpr std::array<float, kLevels> kCardShare = {1.0F, 0.4F, 0.16F};
constexpr std::array<float, kLevels> kCardGrowth = {1.0F, 1.3F, 1.75F};
constexpr std::array<int, kLevels> kTrunkSides = {12, 8, 5};

struct Plant {
  const PlantShape& shape;
  std::uint16_t object;
  const Sunshine& sunshine;
  float ground_z;
  bool below_trees;  ///< as bushes are
};

CornerLight bark_light(const Plant& plant, glm::vec3 p, glm::vec3 normal) {
  const float above_m = p.z - plant.ground_z;
  // Its own crown darkens the sky; so does the ground near the foot.
  const float sky = (0.55F + 0.25F * normal.z) * std::clamp(0.55F + above_m, 0.0F, 1.0F) *
                    (0.5F + 0.5F * plant.shape.light_through(p, {0.0F, 0.0F, 1.0F}));
  const float sun = std::max(0.0F, glm::dot(normal, plant.sunshine.to_sun)) *
                    plant.sunshine.below_crowns(p, plant.ground_z);
  return {sun, sky, 0.0F, 0.0F};
}

std::uint32_t ring(MeshBuilder& builder, const Plant& plant, glm::vec3 middle, float radius_m, int sides,
                   float v) {
  const PieceLook look{plant.shape.bark, plant.object, plant.shape.bark_tint};
  std::uint32_t first = 0;
  for (int i = 0; i <= sides; ++i) {
    const float turn = static_cast<float>(i) / static_cast<float>(sides);
    const float angle = 2.0F * std::numbers::pi_v<float> * turn;
    const glm::vec3 normal(std::cos(angle), std::sin(angle), 0.0F);
    const glm::vec3 p = middle + radius_m * normal;
    const std::uint32_t corner = builder.corner(look, p, {turn, v}, normal, bark_light(plant, p, normal));
    if (i == 0) first = corner;
  }
  return first;
}

/// Rings lie level: trunks are nearly upright, and branches are thin.
void add_limb(MeshBuilder& builder, const Plant& plant, const Limb& limb, int sides, float v_per_m) {
  const std::uint32_t low = ring(builder, plant, limb.from, limb.radius_from_m, sides, v_per_m * limb.from.z);
  const std::uint32_t high = ring(builder, plant, limb.to, limb.radius_to_m, sides, v_per_m * limb.to.z);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(sides); ++i) {
    builder.quad(low + i, low + i + 1, high + i + 1, high + i);
  }
}

IndexRange add_limbs(MeshBuilder& builder, const Plant& plant, int level) {
  const std::uint32_t mark = builder.mark();
  const PlantShape& shape = plant.shape;
  const float girth_m = 2.0F * std::numbers::pi_v<float> * std::max(0.02F, shape.limbs.front().radius_to_m);
  for (std::size_t i = 0; i < shape.limbs.size(); ++i) {
    const bool trunk = static_cast<int>(i) < shape.trunk_limbs;
    if (!trunk && level == 2) break;
    const int sides = kTrunkSides[static_cast<std::size_t>(level)];
    add_limb(builder, plant, shape.limbs[i], trunk ? sides : 4, 1.0F / girth_m);
  }
  return builder.since(mark);
}

CornerLight leaf_light(const Plant& plant, glm::vec3 p, glm::vec3 outward) {
  const float trees = plant.below_trees ? plant.sunshine.below_crowns(p, plant.ground_z) : 1.0F;
  const float sun = trees * plant.shape.light_through(p, plant.sunshine.to_sun);
  const float sky =
      0.08F + 0.72F * plant.shape.light_through(p, glm::normalize(outward + glm::vec3(0.0F, 0.0F, 1.0F)));
  return {sun * (0.35F + 0.65F * std::max(0.0F, glm::dot(outward, plant.sunshine.to_sun))), sky, 0.7F * sun,
          0.5F * sun};
}

void add_card(MeshBuilder& builder, const Plant& plant, const LeafCard& card, float growth) {
  const PieceLook look{plant.shape.leaves, plant.object, plant.shape.leaf_tint};
  std::array<std::uint32_t, 4> corners{};
  constexpr std::array<glm::vec2, 4> kUv = {glm::vec2(0.0F, 0.0F), {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}};
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::vec2 way = growth * (2.0F * kUv[i] - 1.0F);
    const glm::vec3 p = card.middle + way.x * card.half_u + way.y * card.half_v;
    const glm::vec3 outward =
        glm::normalize((p - plant.shape.crown_middle) / plant.shape.crown_radii + glm::vec3(1e-4F));
    corners[i] = builder.corner(look, p, kUv[i], outward, leaf_light(plant, p, outward));
  }
  builder.quad(corners[0], corners[1], corners[2], corners[3]);
}

IndexRange add_leaves(MeshBuilder& builder, const Plant& plant, std::size_t level) {
  const std::uint32_t mark = builder.mark();
  const auto count =
      static_cast<std::size_t>(kCardShare[level] * static_cast<float>(plant.shape.cards.size()));
  for (std::size_t i = 0; i < count; ++i) add_card(builder, plant, plant.shape.cards[i], kCardGrowth[level]);
  return builder.since(mark);
}

Drawable drawable_of(ObjectMesh& mesh, const Plant& plant, float height_m, float reach_m) {
  MeshBuilder builder(mesh);
  Drawable drawable{};
  const PlantShape& shape = plant.shape;
  drawable.middle = {shape.crown_middle.x, shape.crown_middle.y, plant.ground_z + 0.5F * height_m};
  drawable.reach_m = std::hypot(0.6F * height_m, 1.4F * reach_m);
  drawable.level_reach_m = {2.0F * drawable.reach_m, 5.0F * drawable.reach_m};
  for (std::size_t level = 0; level < kLevels; ++level) {
    drawable.solid[level] = add_limbs(builder, plant, static_cast<int>(level));
    drawable.leaves[level] = add_leaves(builder, plant, level);
  }
  return drawable;
}

}  // namespace

void add_tree(ObjectMesh& mesh, const Tree& tree, const Terrain& terrain, const Sunshine& sunshine,
              std::uint16_t object) {
  const PlantShape shape = shape_of(tree, terrain);
  const Plant plant{shape, object, sunshine, static_cast<float>(terrain.height_m(tree.at)), false};
  mesh.drawables.push_back(
      drawable_of(mesh, plant, static_cast<float>(tree.height_m), static_cast<float>(tree.crown_radius_m)));
}

void add_bush(ObjectMesh& mesh, const Bush& bush, const Terrain& terrain, const Sunshine& sunshine,
              std::uint16_t object) {
  const PlantShape shape = shape_of(bush, terrain);
  const Plant plant{shape, object, sunshine, static_cast<float>(terrain.height_m(bush.at)), true};
  mesh.drawables.push_back(
      drawable_of(mesh, plant, static_cast<float>(bush.height_m), static_cast<float>(bush.radius_m)));
}

}  // namespace hindsight
