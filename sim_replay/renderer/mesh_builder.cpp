// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/mesh_builder.h"

#include <algorithm>

namespace hindsight {
namespace {

std::uint8_t byte(float value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255.0F + 0.5F);
}
std::int8_t signed_byte(float value) {
  return static_cast<std::int8_t>(std::clamp(value, -1.0F, 1.0F) * 127.0F);
}

}  // namespace

std::uint32_t MeshBuilder::corner(const PieceLook& look, glm::vec3 p_W, glm::vec2 uv, glm::vec3 normal,
                                  const CornerLight& light) {
  mesh_.vertices.push_back({p_W,
                            uv,
                            {byte(0.5F * look.tint.r), byte(0.5F * look.tint.g), byte(0.5F * look.tint.b), 0},
                            {byte(light.sun), byte(light.sky), byte(light.behind), byte(light.gloss)},
                            {signed_byte(normal.x), signed_byte(normal.y), signed_byte(normal.z), 0},
                            look.layer,
                            look.object});
  return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
}

void MeshBuilder::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
}

void MeshBuilder::quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  triangle(a, b, c);
  triangle(a, c, d);
}

ObjectMesh mesh_of(const World& world, const Sunshine& sunshine) {
  ObjectMesh mesh;
  std::uint16_t object = 0;
  for (const Tree& tree : world.trees) add_tree(mesh, tree, world.terrain, sunshine, ++object);
  for (const Bush& bush : world.bushes) add_bush(mesh, bush, world.terrain, sunshine, ++object);
  for (const Rock& rock : world.rocks) add_rock(mesh, rock, world.terrain, sunshine, ++object);
  for (const Fence& fence : world.fences) add_fence(mesh, fence, world.terrain, sunshine, ++object);
  return mesh;
}

}  // namespace hindsight
