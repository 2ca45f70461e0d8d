// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "sim_replay/world/world.h"

namespace hindsight {

/// A corner of the ground, seen from the camera.
struct GroundVertex {
  glm::vec3 from_camera;
  float slope_light;  ///< sunlight that its slope catches, against level ground
};

/// The ground around the camera as a fan of rings: finer near, coarser far, to the horizon.
class GroundMesh {
 public:
  GroundMesh();
  /// Writes the corners for a camera that looks along heading_rad (from east, counter-clockwise).
  void place(const Terrain& terrain, glm::dvec3 p_WC, double heading_rad, double half_view_rad,
             glm::vec3 to_sun);
  /// Leaves out the triangles that lie beside the picture or behind the camera as a whole.
  void trim(const glm::mat4& clip_from_camera);

  const std::vector<GroundVertex>& vertices() const { return vertices_; }
  /// Of the triangles that trim() has left, in the fan's order.
  const std::vector<std::uint32_t>& indices() const { return indices_; }
  static std::size_t most_indices();

 private:
  std::vector<GroundVertex> vertices_;
  std::vector<std::uint8_t> outside_;  ///< of each corner: the sides of the view beyond which it lies, as bits
  std::vector<std::uint32_t> indices_;
};

}  // namespace hindsight
