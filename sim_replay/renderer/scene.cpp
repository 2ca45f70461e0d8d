// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim_replay/renderer/ground_texture.h"
#include "sim_replay/renderer/object_texture.h"
#include "sim_replay/renderer/shaders.h"
#include "sim_replay/renderer/tiled_noise.h"

namespace hindsight {
namespace {

/// Objects further away are left out.
constexpr float kFarthest_m = 90.0F;
/// Focal length for which the levels of detail are chosen.
constexpr float kLevelFocal_px = 420.0F;

Texels cloud_noise() {
  Texels texels(256, 256);
  for (int y = 0; y < texels.height; ++y) {
    for (int x = 0; x < texels.width; ++x) {
      const float value =
          tiled_fractal(static_cast<float>(x) / 32.0F, static_cast<float>(y) / 32.0F, 8, 5, 3U);
      texels.at(x, y) = glm::vec4(glm::vec3(value * kFullAlbedo), 1.0F);
    }
  }
  return texels;
}

glm::vec3 tone_of(const Texels& texels) {
  glm::vec3 sum(0.0F);
  for (const glm::vec4& texel : texels.rgba) sum += glm::vec3(texel);
  return kFullAlbedo * static_cast<float>(texels.rgba.size()) / sum;
}

GLuint buffer(GLsizeiptr bytes, const void* data, GLbitfield flags) {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  glNamedBufferStorage(id, bytes, data, flags);
  return id;
}

template <typename T>
GLsizeiptr bytes_of(const std::vector<T>& values) {
  return static_cast<GLsizeiptr>(values.size() * sizeof(T));
}

void attribute(GLuint array, GLuint at, GLint count, GLenum type, GLboolean scaled, std::size_t offset) {
  glEnableVertexArrayAttrib(array, at);
  glVertexArrayAttribFormat(array, at, count, type, scaled, static_cast<GLuint>(offset));
  glVertexArrayAttribBinding(array, at, 0);
}

void whole_attribute(GLuint array, GLuint at, std::size_t offset) {
  glEnableVertexArrayAttrib(array, at);
  glVertexArrayAttribIFormat(array, at, 1, GL_UNSIGNED_SHORT, static_cast<GLuint>(offset));
  glVertexArrayAttribBinding(array, at, 0);
}

void set_light(const GlProgram& program, const SceneLight& light) {
  program.set("to_sun", light.to_sun);
  program.set("sun", light.sun);
  program.set("sky", light.sky);
  program.set("haze", light.haze);
  program.set("haze_per_m", light.haze_per_m);
}

std::size_t level_of(const Drawable& drawable, float away_m, float pixel_rad) {
  const float as_if_m = away_m * pixel_rad * kLevelFocal_px;
  const auto good = [&](float reach_m) { return as_if_m < reach_m; };
  const auto& reaches = drawable.level_reach_m;
  return static_cast<std::size_t>(std::find_if(reaches.begin(), reaches.end(), good) - reaches.begin());
}

}  // namespace

Scene::Scene(const World& world)
    : world_(world),
      to_sun_(to_sun_of(world.light)),
      ground_(shaders::ground_vertex, shaders::ground_fragment),
      solid_(shaders::object_vertex, shaders::solid_fragment),
      leaves_(shaders::object_vertex, shaders::leaves_fragment),
      sky_(shaders::screen_vertex, shaders::sky_fragment),
      surfaces_(std::make_unique<GlTextureArray>(object_textures(world.seed), Coverage::kept)),
      noise_(std::make_unique<GlTextureArray>(std::vector<Texels>{cloud_noise()}, Coverage::plain)) {
  const GroundMask mask = ground_mask(world, to_sun_);
  objects_ = mesh_of(world, {to_sun_, mask});
  set_ground(mask);
  load_objects();
  glCreateVertexArrays(1, &empty_array_);
}

Scene::~Scene() {
  for (const GLuint id : {ground_array_, object_array_, empty_array_}) glDeleteVertexArrays(1, &id);
  for (const GLuint id : {ground_corners_, ground_triangles_, object_corners_, object_triangles_}) {
    glDeleteBuffers(1, &id);
  }
}

void Scene::set_ground(const GroundMask& mask) {
  std::vector<Texels> layers;
  const auto add = [&](int kind, Ground ground) {
    layers.push_back(ground_texture(ground, to_sun_, world_.seed));
    const GroundGloss gloss = ground_gloss(ground);
    const GroundVariety variety = ground_variety(ground);
    const auto at = [kind](const char* name) { return fmt::format("{}[{}]", name, kind); };
    ground_.set(at("layer").c_str(), static_cast<float>(layers.size() - 1));
    ground_.set(at("tones").c_str(), tone_of(layers.back()));
    ground_.set(at("dry").c_str(), variety.dry);
    ground_.set(at("moist").c_str(), variety.moist);
    ground_.set(at("gloss").c_str(), glm::vec3(gloss.sheen, gloss.exponent, gloss.wet));
  };
  add(0, world_.ground);
  if (!world_.trails.empty()) add(1, mask.trail);
  if (!world_.patches.empty()) add(2, mask.patch);
  ground_.set("mask_corner", mask.corner_m);
  ground_.set("mask_scale", 1.0F / mask.size_m);
  grounds_ = std::make_unique<GlTextureArray>(layers, Coverage::plain);
  masks_ = std::make_unique<GlMasks>(std::vector<const Texels*>{&mask.light, &mask.kinds});
  glCreateVertexArrays(1, &ground_array_);
  ground_corners_ = buffer(bytes_of(ground_mesh_.vertices()), nullptr, GL_DYNAMIC_STORAGE_BIT);
  ground_triangles_ =
      buffer(static_cast<GLsizeiptr>(GroundMesh::most_indices() * sizeof(std::uint32_t)), nullptr,
             GL_DYNAMIC_STORAGE_BIT);
  glVertexArrayVertexBuffer(ground_array_, 0, ground_corners_, 0, sizeof(GroundVertex));
  glVertexArrayElementBuffer(ground_array_, ground_triangles_);
  attribute(ground_array_, 0, 3, GL_FLOAT, GL_FALSE, offsetof(GroundVertex, from_camera));
  attribute(ground_array_, 1, 1, GL_FLOAT, GL_FALSE, offsetof(GroundVertex, slope_light));
}

void Scene::load_objects() {
  if (objects_.indices.empty()) return;
  glCreateVertexArrays(1, &object_array_);
  object_corners_ = buffer(bytes_of(objects_.vertices), objects_.vertices.data(), 0);
  object_triangles_ = buffer(bytes_of(objects_.indices), objects_.indices.data(), 0);
  glVertexArrayVertexBuffer(object_array_, 0, object_corners_, 0, sizeof(ObjectVertex));
  glVertexArrayElementBuffer(object_array_, object_triangles_);
  attribute(object_array_, 0, 3, GL_FLOAT, GL_FALSE, offsetof(ObjectVertex, p_W));
  attribute(object_array_, 1, 2, GL_FLOAT, GL_FALSE, offsetof(ObjectVertex, uv));
  attribute(object_array_, 2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ObjectVertex, tint));
  attribute(object_array_, 3, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ObjectVertex, light));
  attribute(object_array_, 4, 3, GL_BYTE, GL_TRUE, offsetof(ObjectVertex, normal));
  whole_attribute(object_array_, 5, offsetof(ObjectVertex, layer));
  whole_attribute(object_array_, 6, offsetof(ObjectVertex, object));
  objects_.vertices = {};
  objects_.indices = {};
}

void Scene::draw(const SceneView& view, const WidePinhole& wide, double time_s) {
  const SceneLight light = scene_light(world_.light, time_s);
  glViewport(0, 0, wide.width_px, wide.height_px);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GEQUAL);
  glClearDepth(0.0);
  glClear(GL_DEPTH_BUFFER_BIT);
  draw_objects(view, light, static_cast<float>(1.0 / wide.fx_px));
  draw_ground(view, light, wide);
  draw_sky(view, light, wide, time_s);
  glDisable(GL_DEPTH_TEST);
}

void Scene::draw_objects(const SceneView& view, const SceneLight& light, float pixel_rad) {
  std::vector<std::pair<float, const Drawable*>> seen;
  for (const Drawable& drawable : objects_.drawables) {
    const float away_m = glm::distance(drawable.middle, glm::vec3(view.pose.p_WC));
    if (away_m - drawable.reach_m < kFarthest_m && view.sees(drawable.middle, drawable.reach_m)) {
      seen.emplace_back(away_m, &drawable);
    }
  }
  std::sort(seen.begin(), seen.end());
  std::vector<IndexRange> solid, leaves;
  for (const auto& [away_m, drawable] : seen) {
    const std::size_t level = level_of(*drawable, away_m, pixel_rad);
    solid.push_back(drawable->solid[level]);
    leaves.push_back(drawable->leaves[level]);
  }
  glBindVertexArray(object_array_);
  surfaces_->bind(3);
  for (const GlProgram* program : {&solid_, &leaves_}) {
    set_light(*program, light);
    program->set("clip_from_camera", view.clip_from_camera);
    program->set("camera", glm::vec3(view.pose.p_WC));
  }
  solid_.use();
  draw_ranges(solid);
  leaves_.use();
  leaf_sampler_.bind(3);
  draw_ranges(leaves);
  GlQuickSampler::unbind(3);
}

void Scene::draw_ranges(const std::vector<IndexRange>& ranges) {
  std::vector<GLsizei> counts;
  std::vector<const void*> offsets;
  for (const IndexRange& range : ranges) {
    if (range.count == 0) continue;
    counts.push_back(static_cast<GLsizei>(range.count));
    offsets.push_back(
        reinterpret_cast<const void*>(static_cast<std::uintptr_t>(range.first) * sizeof(std::uint32_t)));
  }
  if (counts.empty()) return;
  glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, offsets.data(),
                      static_cast<GLsizei>(counts.size()));
}

void Scene::draw_ground(const SceneView& view, const SceneLight& light, const WidePinhole& wide) {
  const glm::dvec3 forward = view.pose.R_WC[2];
  const double half_view_rad = std::atan(0.5 * wide.width_px / wide.fx_px) + 0.35;
  ground_mesh_.place(world_.terrain, view.pose.p_WC, std::atan2(forward.y, forward.x), half_view_rad,
                     to_sun_);
  ground_mesh_.trim(view.clip_from_camera);
  glNamedBufferSubData(ground_corners_, 0, bytes_of(ground_mesh_.vertices()), ground_mesh_.vertices().data());
  glNamedBufferSubData(ground_triangles_, 0, bytes_of(ground_mesh_.indices()), ground_mesh_.indices().data());
  set_light(ground_, light);
  ground_.set("clip_from_camera", view.clip_from_camera);
  ground_.set("camera_at", glm::vec2(view.pose.p_WC));
  ground_.set("pixel_rad", static_cast<float>(1.0 / wide.fx_px));
  grounds_->bind(0);
  masks_->bind(1);
  ground_.use();
  glBindVertexArray(ground_array_);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(ground_mesh_.indices().size()), GL_UNSIGNED_INT, nullptr);
}

void Scene::draw_sky(const SceneView& view, const SceneLight& light, const WidePinhole& wide, double time_s) {
  set_light(sky_, light);
  const bool wooded = !world_.trees.empty();
  sky_.set("far_albedo", wooded ? glm::vec3(0.055F, 0.065F, 0.035F) : glm::vec3(0.12F, 0.105F, 0.08F));
  sky_.set("far_height", wooded ? 0.085F : 0.035F);
  sky_.set("far_left", std::exp(-(wooded ? 120.0F : 900.0F) * light.haze_per_m));
  sky_.set("horizon", light.horizon);
  sky_.set("zenith", light.zenith);
  sky_.set("clouds", light.clouds);
  sky_.set("drift", static_cast<float>(std::fmod(0.0008 * time_s, 1.0)));
  sky_.set("world_from_camera", glm::mat3(view.pose.R_WC));
  sky_.set("pinhole", glm::vec4(1.0 / wide.fx_px, 1.0 / wide.fy_px, wide.cx_px, wide.cy_px));
  noise_->bind(4);
  sky_.use();
  glBindVertexArray(empty_array_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace hindsight
