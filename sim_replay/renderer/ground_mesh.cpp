// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/ground_mesh.h"

#include <algorithm>
#include <array>
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

/// Directions from the hub.
std::array<glm::dvec2, kSpokes> spokes(double heading_rad, double half_view_rad) {
  std::array<glm::dvec2, kSpokes> ways;
  for (int spoke = 0; spoke < kSpokes; ++spoke) {
    const double angle = heading_rad + half_view_rad * (2.0 * spoke / (kSpokes - 1.0) - 1.0);
    ways[static_cast<std::size_t>(spoke)] = {std::cos(angle), std::sin(angle)};
  }
  return ways;
}

/// The sides of the view beyond which a place lies, by more than rounding can be off: left, right, top, bottom
/// and behind.
std::uint8_t sides_beyond(const glm::mat4& clip_from_camera, glm::vec3 from_camera) {
  const glm::vec4 clip = clip_from_camera * glm::vec4(from_camera, 1.0F);
  const float within = -1e-5F * (1.0F + glm::length(from_camera));
  const std::array<bool, 5> beyond = {clip.w + clip.x < within, clip.w - clip.x < within,
                                      clip.w + clip.y < within, clip.w - clip.y < within, clip.w < within};
  unsigned bits = 0;
  for (std::size_t side = 0; side < beyond.size(); ++side) bits |= unsigned{beyond[side]} << side;
  return static_cast<std::uint8_t>(bits);
}

}  // namespace

GroundMesh::GroundMesh()
    : vertices_(static_cast<std::size_t>(kRings * kSpokes)), outside_(vertices_.size()) {
  indices_.reserve(most_indices());
}

std::size_t GroundMesh::most_indices() { return std::size_t{6} * (kRings - 1) * (kSpokes - 1); }

void GroundMesh::place(const Terrain& terrain, glm::dvec3 p_WC, double heading_rad, double half_view_rad,
                       glm::vec3 to_sun) {
  // A step back, so that what lies beside the camera is in the fan as well.
  const glm::dvec2 hub = glm::dvec2(p_WC) - 1.5 * glm::dvec2(std::cos(heading_rad), std::sin(heading_rad));
  const std::array<glm::dvec2, kSpokes> ways = spokes(heading_rad, half_view_rad);
  auto vertex = vertices_.begin();
  for (int ring = 0; ring < kRings; ++ring) {
    const double away_m = ring == 0 ? 0.0 : ring_m(ring);
    for (const glm::dvec2 way : ways) {
      const WorldPoint p{hub.x + away_m * way.x, hub.y + away_m * way.y};
      const WorldPoint rise = terrain.gradient(p);
      const glm::dvec3 normal = glm::normalize(glm::dvec3(-rise.x_m, -rise.y_m, 1.0));
      const double sun = std::max(0.0, glm::dot(normal, glm::dvec3(to_sun))) / static_cast<double>(to_sun.z);
      *vertex++ = {glm::vec3(glm::dvec3(p.x_m, p.y_m, terrain.height_m(p)) - p_WC), static_cast<float>(sun)};
    }
  }
}

void GroundMesh::trim(const glm::mat4& clip_from_camera) {
  std::transform(vertices_.begin(), vertices_.end(), outside_.begin(), [&](const GroundVertex& vertex) {
    return sides_beyond(clip_from_camera, vertex.from_camera);
  });
  indices_.clear();
  const auto add = [this](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if ((outside_[a] & outside_[b] & outside_[c]) == 0) indices_.insert(indices_.end(), {a, b, c});
  };
  for (std::uint32_t ring = 0; ring + 1 < kRings; ++ring) {
    for (std::uint32_t spoke = 0; spoke + 1 < kSpokes; ++spoke) {
      const std::uint32_t a = ring * kSpokes + spoke, b = a + kSpokes;
      add(a, b, a + 1);
      add(a + 1, b, b + 1);
    }
  }
}

}  // namespace hindsight
