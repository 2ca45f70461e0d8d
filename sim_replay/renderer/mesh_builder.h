// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <glm/glm.hpp>

#include "sim_replay/renderer/object_mesh.h"

namespace hindsight {

/// What the corners of a piece have in common.
struct PieceLook {
  std::uint16_t layer = 0;
  std::uint16_t object = 0;
  glm::vec3 tint{1.0F};
};

struct CornerLight {
  float sun = 1.0F, sky = 1.0F, behind = 0.0F, gloss = 0.0F;
};

/// Adds corners and triangles to a mesh.
class MeshBuilder {
 public:
  explicit MeshBuilder(ObjectMesh& mesh) : mesh_(mesh) {}

  std::uint32_t corner(const PieceLook& look, glm::vec3 p_W, glm::vec2 uv, glm::vec3 normal,
                       const CornerLight& light);
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  /// Corners a b c d in turn.
  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);

  std::uint32_t mark() const { return static_cast<std::uint32_t>(mesh_.indices.size()); }
  IndexRange since(std::uint32_t mark) const { return {mark, this->mark() - mark}; }

 private:
  ObjectMesh& mesh_;
};

void add_tree(ObjectMesh& mesh, const Tree& tree, const Terrain& terrain, const Sunshine& sunshine,
              std::uint16_t object);
void add_bush(ObjectMesh& mesh, const Bush& bush, const Terrain& terrain, const Sunshine& sunshine,
              std::uint16_t object);
void add_rock(ObjectMesh& mesh, const Rock& rock, const Terrain& terrain, const Sunshine& sunshine,
              std::uint16_t object);
void add_fence(ObjectMesh& mesh, const Fence& fence, const Terrain& terrain, const Sunshine& sunshine,
               std::uint16_t object);

}  // namespace hindsight
