// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/shaders.h"

namespace hindsight::shaders {

const char* const ground_vertex = R"(
layout(location = 0) in vec3 p;       // from the camera
layout(location = 1) in float slope;  // sunlight against level ground
uniform mat4 clip_from_camera;
uniform vec2 camera_at;
out vec3 v_p;
out vec2 v_at;
out float v_slope;
void main() {
  v_p = p;
  v_at = p.xy + camera_at;
  v_slope = slope;
  gl_Position = clip_from_camera * vec4(p, 1.0);
}
)";

// Two taps along the direction of view stand for anisotropic filtering.
const char* const ground_fragment = R"(
in vec3 v_p;
in vec2 v_at;
in float v_slope;
layout(location = 0) out vec4 colour;
layout(location = 1) out uint object;
layout(binding = 0) uniform sampler2DArray kinds;
layout(binding = 1) uniform sampler2DArray masks;  // of light, of kinds
uniform vec2 mask_corner, mask_scale;
uniform vec3 to_sun, sun, sky, haze;
uniform float haze_per_m, pixel_rad;
// Of the ground, of trails, of patches.
uniform float layer[3];
uniform vec3 tones[3];      // 1 / mean albedo, as texture values
uniform vec3 gloss[3];      // sheen, exponent, wet
uniform vec3 dry[3], moist[3];
const float tile_m = 2.0, texel_m = tile_m / 1024.0;
vec4 taken(float layer, vec2 at, vec2 off, float lod) {
  return 0.5 * (textureLod(kinds, vec3((at + off) / tile_m, layer), lod) +
                textureLod(kinds, vec3((at - off) / tile_m, layer), lod));
}
vec4 kind(float layer, vec3 tone, vec2 at, vec2 off, float lod) {
  vec4 fine = taken(layer, at, off, lod);
  vec3 coarse = textureLod(kinds, vec3(at.yx / (4.37 * tile_m), layer), max(0.0, lod - 1.1)).rgb * tone;
  return vec4(fine.rgb * (0.45 + 0.55 * coarse), fine.a);
}
void main() {
  float away = length(v_p);
  vec3 view = -v_p / away;
  float rise = max(view.z, 0.015);
  float across_m = away * pixel_rad, along_m = across_m / rise;
  float lod = log2(max(0.5 * along_m, across_m) / texel_m);
  vec2 off = normalize(v_p.xy) * (0.25 * along_m);
  vec2 in_mask = (v_at - mask_corner) * mask_scale;
  vec4 light = texture(masks, vec3(in_mask, 0.0));
  vec4 which = texture(masks, vec3(in_mask, 1.0));
  // llvmpipe runs both sides of an if, but leaves a loop: most pixels go round once.
  vec3 share = vec3((1.0 - which.r) * (1.0 - which.g), which.r * (1.0 - which.g), which.g);
  vec4 ground = vec4(0.0);
  vec3 shine = vec3(0.0);
  while (true) {
    int k = share.x > 0.004 ? 0 : share.y > 0.004 ? 1 : 2;
    ground += share[k] * kind(layer[k], tones[k], v_at, off, lod) * vec4(mix(moist[k], dry[k], which.b), 1.0);
    shine += share[k] * gloss[k];
    share[k] = 0.0;
    if (max(share.x, max(share.y, share.z)) < 0.004) break;
  }
  vec3 albedo = ground.rgb * (0.5 * (0.4 + 1.2 * light.a));
  float sunlit = 2.0 * ground.a * v_slope * light.r;
  vec3 half_way = normalize(view + to_sun);
  float graze = (1.0 - rise) * (1.0 - rise);
  float sheen = shine.x * (pow(max(half_way.z, 0.0), shine.y) * 0.3 + 0.7 * graze * (0.6 - 0.4 * dot(view.xy, to_sun.xy)));
  float mirror = shine.z * (0.03 + 0.97 * graze * graze);
  vec3 lit = albedo * (sun * (to_sun.z * sunlit) + sky * light.g) + sheen * (sun * (sunlit * light.r) + 0.5 * sky) * light.g * (0.3 + albedo) +
             mirror * haze * light.g;
  colour = vec4(mix(haze, lit, exp(-away * haze_per_m)), 1.0);
  object = which.r > 0.5 && which.g < 0.5 ? 65534u : 65535u;
}
)";

const char* const object_vertex = R"(
layout(location = 0) in vec3 p;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 tint;
layout(location = 3) in vec4 light;
layout(location = 4) in vec3 normal;
layout(location = 5) in uint layer;
layout(location = 6) in uint object;
uniform mat4 clip_from_camera;
uniform vec3 camera, to_sun, sun, sky;
uniform float haze_per_m;
out vec3 v_uv;
out vec3 v_light;
out vec4 v_gloss;  // and what haze leaves
flat out uint v_object;
void main() {
  vec3 from_camera = p - camera;
  float away = length(from_camera);
  vec3 view = -from_camera / away;
  v_uv = vec3(uv, float(layer));
  float behind = light.z * pow(max(0.0, 0.2 - 0.8 * dot(view, to_sun)), 1.5);
  v_light = tint.rgb * (sun * (light.x + behind) + sky * light.y);
  float shine = light.w * pow(max(0.0, dot(normal, normalize(view + to_sun))), 6.0);
  float left = exp(-away * haze_per_m);
  v_gloss = vec4(sun * shine * 0.06 * left, left);
  v_object = object;
  gl_Position = clip_from_camera * vec4(from_camera, 1.0);
}
)";

const char* const solid_fragment = R"(
in vec3 v_uv;
in vec3 v_light;
in vec4 v_gloss;
flat in uint v_object;
layout(location = 0) out vec4 colour;
layout(location = 1) out uint object;
layout(binding = 3) uniform sampler2DArray surfaces;
uniform vec3 haze;
void main() {
  vec3 lit = texture(surfaces, v_uv).rgb * v_light;
  colour = vec4(mix(haze, lit, v_gloss.a) + v_gloss.rgb, 1.0);
  object = v_object;
}
)";

const char* const leaves_fragment = R"(
in vec3 v_uv;
in vec3 v_light;
in vec4 v_gloss;
flat in uint v_object;
layout(location = 0) out vec4 colour;
layout(location = 1) out uint object;
layout(binding = 3) uniform sampler2DArray surfaces;
uniform vec3 haze;
void main() {
  vec4 leaf = texture(surfaces, v_uv);
  if (leaf.a < 0.5) discard;
  colour = vec4(mix(haze, leaf.rgb * v_light, v_gloss.a) + v_gloss.rgb, 1.0);
  object = v_object;
}
)";

}  // namespace hindsight::shaders
