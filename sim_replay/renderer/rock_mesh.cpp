// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim_replay/renderer/mesh_builder.h"
#include "sim_replay/renderer/object_texture.h"
#include "sim_replay/world/random.h"

namespace hindsight {
namespace {

constexpr int kRings = 8;
constexpr int kSides = 14;

/// A few planes cut a ball: how far the surface is out, as a share of the radius.
struct Cuts {
  std::vector<glm::vec4> planes;

  explicit Cuts(std::uint32_t look) {
    Random random(look, 5);
    const auto any = [&](double low, double high) { return static_cast<float>(random.uniform(low, high)); };
    for (int i = 0; i < 12; ++i) {
      planes.emplace_back(glm::normalize(glm::vec3(any(-1.0, 1.0), any(-1.0, 1.0), any(0.0, 1.0)) + 1e-3F),
                          any(0.72, 0.95));
    }
  }
  float out(glm::vec3 direction) const {
    float out = 1.0F;
    for (const glm::vec4& plane : planes) {
      const float towards = glm::dot(glm::vec3(plane), direction);
      if (towards > 0.1F) out = std::min(out, plane.w / towards);
    }
    return out;
  }
};

}  // namespace

void add_rock(ObjectMesh& mesh, const Rock& rock, const Terrain& terrain, const Sunshine& sunshine,
              std::uint16_t object) {
  MeshBuilder builder(mesh);
  const Cuts cuts(rock.look);
  const auto radius_m = static_cast<float>(rock.radius_m), height_m = static_cast<float>(rock.height_m);
  const glm::vec3 base(rock.at.x_m, rock.at.y_m, terrain.height_m(rock.at));
  const PieceLook look{rock_face, object, glm::vec3(0.8F + 0.05F * static_cast<float>(rock.look % 8U))};
  const auto p_at = [&](int i, int k) {
    const float up = 0.5F * std::numbers::pi_v<float> * (static_cast<float>(i) / kRings * 1.3F - 0.3F);
    const float turn = 2.0F * std::numbers::pi_v<float> * static_cast<float>(k % kSides) / kSides;
    const glm::vec3 direction(std::cos(up) * std::cos(turn), std::cos(up) * std::sin(turn), std::sin(up));
    return base + cuts.out(direction) * direction * glm::vec3(radius_m, radius_m, height_m * 1.05F);
  };
  const std::uint32_t mark = builder.mark();
  for (int i = 0; i < kRings; ++i) {
    for (int k = 0; k < kSides; ++k) {
      const std::array<glm::vec3, 4> p = {p_at(i, k), p_at(i, k + 1), p_at(i + 1, k + 1), p_at(i + 1, k)};
      const glm::vec3 normal = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
      std::array<std::uint32_t, 4> corners{};
      for (std::size_t c = 0; c < 4; ++c) {
        const float low = std::clamp((p[c].z - base.z) / height_m + 0.35F, 0.3F, 1.0F);
        const CornerLight light{
            std::max(0.0F, glm::dot(normal, sunshine.to_sun)) * sunshine.below_crowns(p[c], base.z),
            (0.6F + 0.4F * normal.z) * low, 0.0F, 0.0F};
        corners[c] =
            builder.corner(look, p[c], glm::vec2(p[c].x + 0.3F * p[c].z, p[c].y + p[c].z), normal, light);
      }
      builder.quad(corners[0], corners[1], corners[2], corners[3]);
    }
  }
  Drawable drawable{base, std::max(radius_m, height_m), {}, {}, {}};
  drawable.solid.fill(builder.since(mark));
  mesh.drawables.push_back(drawable);
}

}  // namespace hindsight
