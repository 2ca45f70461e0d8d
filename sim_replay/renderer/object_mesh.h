// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "sim_replay/renderer/sunshine.h"
#include "sim_replay/world/world.h"

namespace hindsight {

/// A corner of what stands in the world, with the light that falls on it: nothing moves but the camera.
struct ObjectVertex {
  glm::vec3 p_W;
  glm::vec2 uv;
  std::array<std::uint8_t, 4> tint;   ///< half of the factor to the texture's colour; fourth: unused
  std::array<std::uint8_t, 4> light;  ///< sun, sky, sun from behind (through leaves), gloss
  std::array<std::int8_t, 4> normal;
  std::uint16_t layer;
  std::uint16_t object;  ///< as RenderedFrame::objects
};

struct IndexRange {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

constexpr int kLevels = 3;

/// A thing that is drawn or left out as a whole, in levels of detail, near ones first.
struct Drawable {
  glm::vec3 middle;
  float reach_m;
  std::array<float, kLevels - 1> level_reach_m;  ///< up to where a level is good, at a pixel of 1/420 rad
  std::array<IndexRange, kLevels> solid;
  std::array<IndexRange, kLevels> leaves;
};

struct ObjectMesh {
  std::vector<ObjectVertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<Drawable> drawables;  ///< a fence has one for each span
};

ObjectMesh mesh_of(const World& world, const Sunshine& sunshine);

}  // namespace hindsight
