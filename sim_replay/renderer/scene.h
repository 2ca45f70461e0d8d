// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <vector>

#include "sim_replay/renderer/gl_program.h"
#include "sim_replay/renderer/gl_texture.h"
#include "sim_replay/renderer/ground_mask.h"
#include "sim_replay/renderer/ground_mesh.h"
#include "sim_replay/renderer/object_mesh.h"
#include "sim_replay/renderer/scene_view.h"

namespace hindsight {

/// Numbers in the picture of objects that are none.
constexpr std::uint16_t kGroundObject = 65535;
constexpr std::uint16_t kTrailObject = 65534;

/// A World as OpenGL objects. Lives and dies while its context is current.
class Scene {
 public:
  explicit Scene(const World& world);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Draws into the bound frame buffer: light, and objects where it has room for them.
  void draw(const SceneView& view, const WidePinhole& wide, double time_s);

 private:
  void set_ground(const GroundMask& mask);
  void load_objects();
  void draw_objects(const SceneView& view, const SceneLight& light, float pixel_rad);
  void draw_ground(const SceneView& view, const SceneLight& light, const WidePinhole& wide);
  void draw_sky(const SceneView& view, const SceneLight& light, const WidePinhole& wide, double time_s);
  void draw_ranges(const std::vector<IndexRange>& ranges);

  const World world_;
  glm::vec3 to_sun_;
  GlProgram ground_, solid_, leaves_, sky_;
  std::unique_ptr<GlTextureArray> grounds_, surfaces_, noise_;
  GlQuickSampler leaf_sampler_;
  std::unique_ptr<GlMasks> masks_;
  GroundMesh ground_mesh_;
  ObjectMesh objects_;
  GLuint ground_array_ = 0, object_array_ = 0, empty_array_ = 0;
  GLuint ground_corners_ = 0, ground_triangles_ = 0, object_corners_ = 0, object_triangles_ = 0;
};

}  // namespace hindsight
