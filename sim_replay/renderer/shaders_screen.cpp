// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/shaders.h"

namespace hindsight::shaders {

// One triangle over the whole picture, as far away as can be.
const char* const screen_vertex = R"(
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

const char* const sky_fragment = R"(
layout(location = 0) out vec4 colour;
layout(location = 1) out uint object;
layout(binding = 4) uniform sampler2DArray noise;
uniform mat3 world_from_camera;
uniform vec4 pinhole;  // 1 / focal lengths, principal point
uniform vec3 to_sun, sun, haze, horizon, zenith, far_albedo;
uniform float clouds, drift, far_height, far_left;
// Woods or hills that close the view all round.
vec4 far_land(vec3 way) {
  vec2 round = normalize(way.xy);
  float skyline = texture(noise, vec3(round * 0.9, 0.0)).r * 0.8 + texture(noise, vec3(round * 7.0, 0.0)).r * 0.2;
  float top = far_height * (0.25 + 1.5 * skyline) + 0.35 * far_height * (texture(noise, vec3(round * 23.0, 0.0)).r - 0.5);
  float crown = texture(noise, vec3(round * 15.0 + way.z * 25.0, 0.0)).r;
  vec3 lit = far_albedo * (0.2 + 1.9 * crown * crown) * (sun * 0.45 + 0.5);
  return vec4(mix(haze, lit, far_left), smoothstep(-0.0012, 0.0012, top - way.z));
}
void main() {
  vec2 px = gl_FragCoord.xy - 0.5;
  vec3 way = normalize(world_from_camera * vec3((px - pinhole.zw) * pinhole.xy, 1.0));
  float up = max(way.z, 0.0);
  vec3 blue = mix(horizon, zenith, 1.0 - exp(-4.0 * up));
  float towards = max(0.0, dot(way, to_sun));
  blue += sun * (0.10 * pow(towards, 6.0) + 0.6 * pow(towards, 200.0));
  vec2 at = way.xy / (up + 0.12) * 0.13 + drift;
  float cover = texture(noise, vec3(at, 0.0)).r * 0.65 + texture(noise, vec3(at * 3.7, 0.0)).r * 0.35;
  float cloud = smoothstep(1.0 - clouds, 1.25 - clouds, cover) * smoothstep(0.0, 0.12, up);
  vec4 land = far_land(way);
  colour = vec4(mix(mix(blue, horizon * 1.1 + 0.2 * sun, cloud), land.rgb, land.a), 1.0);
  object = 0u;
}
)";

// From light to bytes: lens, motion blur, vignetting, exposure, shot and read noise, sRGB.
const char* const sensor_fragment = R"(
layout(location = 0) out vec4 bytes;
layout(binding = 5) uniform sampler2D scene;
layout(binding = 6) uniform sampler2D depth;
layout(binding = 7) uniform sampler2D sources;
uniform mat4 before_from_now;  // wide pixel and 1 / depth, homogeneous
uniform vec2 wide_size;
uniform float near_m, open_share, exposure, electrons, read_electrons, vignette;
uniform vec2 middle;
uniform uint frame;
uint mixed(uint h) {
  h ^= h >> 16; h *= 0x7feb352du; h ^= h >> 15; h *= 0x846ca68bu; h ^= h >> 16;
  return h;
}
// Sum of four bytes: mean 510, variance 4 * (256^2 - 1) / 12.
float bell(uint h) {
  uint sum = (h & 255u) + ((h >> 8) & 255u) + ((h >> 16) & 255u) + (h >> 24);
  return (float(sum) - 510.0) * (1.0 / 147.8);
}
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec2 px = texelFetch(sources, at, 0).xy;
  float inverse_m = texelFetch(depth, ivec2(px + 0.5), 0).r / near_m;
  vec3 before = (before_from_now * vec4(px, 1.0, inverse_m)).xyz;
  vec2 blur = (px - before.xy / before.z) * open_share;
  blur *= min(1.0, 24.0 / (length(blur) + 1e-6));
  vec2 tap = blur * 0.3333 + vec2(0.22, 0.17);
  vec2 scale = 1.0 / wide_size;
  vec3 light = (texture(scene, (px + 0.5) * scale).rgb + texture(scene, (px + 0.5 + tap) * scale).rgb +
                texture(scene, (px + 0.5 - tap) * scale).rgb) * 0.33333;
  vec2 out_by = (vec2(at) - middle) / middle.x;
  float fall = 1.0 / (1.0 + vignette * dot(out_by, out_by));
  // Dyes let the neighbours' colour through, white is balanced for daylight's blue share, glass scatters a little.
  light = mix(vec3(dot(light, vec3(0.3, 0.45, 0.25))), light, 0.66) * vec3(0.97, 0.99, 1.12) + 0.006;
  vec3 signal = light * (exposure * fall * fall);
  uint h = mixed(uint(at.x) + uint(at.y) * 8192u + frame * 0x9e3779b9u);
  vec3 noise = vec3(bell(h), bell(mixed(h + 1u)), bell(mixed(h + 2u)));
  vec3 count = min(signal, vec3(1.5)) * electrons;
  signal += noise * sqrt(count + read_electrons * read_electrons) / electrons;
  signal = clamp(signal, 0.0, 1.0);
  // sRGB of signal^1.3, the steeper contrast that cameras set as standard; its straight foot is below 10 of 255.
  bytes = vec4(1.055 * pow(signal, vec3(1.3 / 2.4)) - 0.055, 1.0);
}
)";

}  // namespace hindsight::shaders
