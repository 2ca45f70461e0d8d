// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/ground_mesh.h"

#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

constexpr int kRings = 90;
constexpr int kSpokes = 49;
constexpr double kFirst_m = 0.15;
constexpr double kLast_m = 1500.0;

double ring_m(int ring) {
  return ring == 0 ? -2.0 : kFirst_m * std::pow(kLast_m / kFirst_m, (ring - 1.0) / (kRings - 2.0));
}

}  // namespace

GroundMesh::GroundMesh() : vertices_(static_cast<std::size_t>(kRings * kSpokes)) {
  for (std::uint32_t ring = 0; ring + 1 < kRings; ++ring) {
    for (std::uint32_t spoke = 0; spoke + 1 < kSpokes; ++spoke) {
      const std::uint32_t a = ring * kSpokes + spoke, b = a + kSpokes;
      indices_.insert(indices_.end(), {a, b, a + 1, a + 1, b, b + 1});
    }
  }
}

void GroundMesh::place(const Terrain& terrain, glm::dvec3 p_WC, double heading_rad, double half_view_rad,
                       glm::vec3 to_sun) {
  // A step back, so that what lies beside the camera is in the fan as well.
  const glm::dvec2 hub = glm::dvec2(p_WC) - 1.5 * glm::dvec2(std::cos(heading_rad), std::sin(heading_rad));
  for (int ring = 0; ring < kRings; ++ring) {
    const double away_m = ring == 0 ? 0.0 : ring_m(ring);
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const double angle = heading_rad + half_view_rad * (2.0 * spoke / (kSpokes - 1.0) - 1.0);
      const WorldPoint p{hub.x + away_m * std::cos(angle), hub.y + away_m * std::sin(angle)};
      const WorldPoint rise = terrain.gradient(p);
      const glm::dvec3 normal = glm::normalize(glm::dvec3(-rise.x_m, -rise.y_m, 1.0));
      const double sun = std::max(0.0, glm::dot(normal, glm::dvec3(to_sun))) / static_cast<double>(to_sun.z);
      vertices_[static_cast<std::size_t>(ring * kSpokes + spoke)] = {
          glm::vec3(glm::dvec3(p.x_m, p.y_m, terrain.height_m(p)) - p_WC), static_cast<float>(sun)};
    }
  }
}

}  // namespace hindsight
