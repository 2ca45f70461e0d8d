// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>

#include "sim_replay/renderer/mesh_builder.h"
#include "sim_replay/renderer/object_texture.h"

namespace hindsight {
namespace {

/// The mesh's strands: width, and distance of the level and of the upright ones. From afar, fewer and wider
/// ones cover as much.
constexpr float kStrand_m = 0.014F;
constexpr float kLevel_m = 0.075F;
constexpr float kUpright_m = 0.06F;
constexpr std::array<float, kLevels> kCoarser = {1.0F, 2.0F, 4.0F};
constexpr std::array<float, kLevels - 1> kLevelReach_m = {6.0F, 13.0F};

struct Span {
  glm::vec3 from, to;  ///< feet of two posts
  float height_m;

  glm::vec3 along() const { return glm::normalize(to - from); }
  /// Sags between its posts.
  glm::vec3 at(float share, float up_m) const {
    const float sag_m = 0.08F * share * (1.0F - share) * 4.0F * up_m / height_m;
    return glm::mix(from, to, share) + glm::vec3(0.0F, 0.0F, up_m - sag_m);
  }
};

class FenceBuilder {
 public:
  FenceBuilder(ObjectMesh& mesh, glm::vec3 to_sun, std::uint16_t object)
      : builder_(mesh), to_sun_(to_sun), object_(object) {}

  void strip(glm::vec3 a, glm::vec3 b, glm::vec3 half_width, glm::vec3 normal) {
    const PieceLook look{plastic, object_, glm::vec3(1.0F)};
    const float facing = glm::dot(normal, to_sun_);
    // Thin plastic: what falls on its other side shines through.
    const CornerLight light{0.65F * std::abs(facing) + 0.25F, 0.6F, 0.35F, 0.1F};
    const auto corner = [&](glm::vec3 p) {
      return builder_.corner(look, p, {p.x + p.y, p.z}, normal, light);
    };
    builder_.quad(corner(a - half_width), corner(b - half_width), corner(b + half_width),
                  corner(a + half_width));
  }

  void mesh(const Span& span, float coarser) {
    const glm::vec3 up(0.0F, 0.0F, 1.0F), along = span.along(),
                                          normal = glm::normalize(glm::cross(along, up));
    const float length_m = glm::distance(span.from, span.to);
    const int pieces = std::max(1, static_cast<int>(length_m / 0.5F));
    for (float z = 0.04F * coarser; z <= span.height_m; z += coarser * kLevel_m) {
      for (int i = 0; i < pieces; ++i) {
        const float n = static_cast<float>(pieces), k = static_cast<float>(i);
        strip(span.at(k / n, z), span.at((k + 1.0F) / n, z), 0.5F * coarser * kStrand_m * up, normal);
      }
    }
    for (float s_m = 0.5F * coarser * kUpright_m; s_m < length_m; s_m += coarser * kUpright_m) {
      const float share = s_m / length_m;
      strip(span.at(share, 0.03F), span.at(share, span.height_m), 0.4F * coarser * kStrand_m * along, normal);
    }
  }

  void post(glm::vec3 foot, float height_m) {
    const PieceLook look{scaly_bark, object_, glm::vec3(0.8F)};
    std::array<std::uint32_t, 10> ring{};
    for (std::size_t i = 0; i < 5; ++i) {
      const float angle = 1.5708F * static_cast<float>(i) + 0.4F;
      const glm::vec3 normal(std::cos(angle), std::sin(angle), 0.0F), p = foot + 0.03F * normal;
      const CornerLight light{std::max(0.0F, glm::dot(normal, to_sun_)), 0.5F, 0.0F, 0.0F};
      const float u = 0.25F * static_cast<float>(i);
      ring[i] = builder_.corner(look, p - glm::vec3(0.0F, 0.0F, 0.1F), {u, 0.0F}, normal, light);
      ring[i + 5] =
          builder_.corner(look, p + glm::vec3(0.0F, 0.0F, height_m + 0.05F), {u, 2.0F}, normal, light);
    }
    for (std::size_t i = 0; i < 4; ++i) builder_.quad(ring[i], ring[i + 1], ring[i + 6], ring[i + 5]);
  }

 private:
  MeshBuilder builder_;
  glm::vec3 to_sun_;
  std::uint16_t object_;
};

glm::vec3 foot(WorldPoint p, const Terrain& terrain) { return {p.x_m, p.y_m, terrain.height_m(p)}; }

}  // namespace

void add_fence(ObjectMesh& mesh, const Fence& fence, const Terrain& terrain, const Sunshine& sunshine,
               std::uint16_t object) {
  FenceBuilder builder(mesh, sunshine.to_sun, object);
  const auto height_m = static_cast<float>(fence.height_m);
  for (std::size_t i = 1; i < fence.posts.size(); ++i) {
    const Span span{foot(fence.posts[i - 1], terrain), foot(fence.posts[i], terrain), height_m};
    Drawable drawable{span.at(0.5F, 0.5F * height_m),
                      0.5F * glm::distance(span.from, span.to) + height_m,
                      kLevelReach_m,
                      {},
                      {}};
    for (std::size_t level = 0; level < kLevels; ++level) {
      const std::uint32_t mark = MeshBuilder(mesh).mark();
      if (i == 1) builder.post(span.from, height_m);
      builder.post(span.to, height_m);
      builder.mesh(span, kCoarser[level]);
      drawable.solid[level] = MeshBuilder(mesh).since(mark);
    }
    mesh.drawables.push_back(drawable);
  }
}

}  // namespace hindsight
