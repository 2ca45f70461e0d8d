// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "sim_replay/world/world.h"

namespace hindsight {

/// A corner of the ground, seen from the camera.
struct GroundVertex {
  glm::vec3 from_camera;
  float slope_light;  ///< sunlight that its slope catches, against level ground
};

/// The ground around the camera as a fan of rings: finer near, coarser far, to the horizon. The corners of
/// all frames are joined by the same triangles.
class GroundMesh {
 public:
  GroundMesh();
  /// Writes the corners for a camera that looks along heading_rad (from east, counter-clockwise).
  void place(const Terrain& terrain, glm::dvec3 p_WC, double heading_rad, double half_view_rad,
             glm::vec3 to_sun);

  const std::vector<GroundVertex>& vertices() const { return vertices_; }
  const std::vector<std::uint32_t>& indices() const { return indices_; }

 private:
  std::vector<GroundVertex> vertices_;
  std::vector<std::uint32_t> indices_;
};

}  // namespace hindsight
