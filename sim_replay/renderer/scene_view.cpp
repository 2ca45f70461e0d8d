// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/scene_view.h"

#include <cmath>

namespace hindsight {

glm::vec3 to_sun_of(const Light& light) {
  const double level = std::cos(light.sun_elevation_rad);
  return {level * std::cos(light.sun_azimuth_rad), level * std::sin(light.sun_azimuth_rad),
          std::sin(light.sun_elevation_rad)};
}

SceneLight scene_light(const Light& light, double time_s) {
  // Clouds pass in waves of half a minute and of a few seconds.
  const double wave = 0.6 * std::sin(0.21 * time_s + 1.0) + 0.4 * std::sin(0.83 * time_s + 2.0);
  const auto strength =
      static_cast<float>(light.sun_strength * (1.0 - light.cloud_depth * (0.5 + 0.5 * wave)));
  const glm::vec3 to_sun = to_sun_of(light);
  // Air takes more of a low sun, and of its blue most (Kasten and Young's air mass, about 1 / sin).
  const float air = 1.0F / (to_sun.z + 0.15F);
  const glm::vec3 sun = glm::exp(-air * glm::vec3(0.06F, 0.11F, 0.20F)) * (3.4F * strength);
  const glm::vec3 overcast(0.95F, 1.0F, 1.05F), clear(0.52F, 0.64F, 0.84F);
  const glm::vec3 sky = glm::mix(overcast * 1.4F, clear * 0.75F, strength);
  const glm::vec3 haze = glm::mix(glm::vec3(1.7F, 1.75F, 1.8F), glm::vec3(1.55F, 1.72F, 1.85F), strength);
  const glm::vec3 zenith = glm::mix(glm::vec3(1.3F, 1.35F, 1.4F), glm::vec3(0.42F, 0.68F, 1.15F), strength);
  return {to_sun,
          sun,
          sky,
          0.33F * haze,
          haze,
          zenith,
          static_cast<float>(1.0 / light.haze_range_m),
          0.62F - 0.12F * strength};
}

SceneView::SceneView(const CameraPose& camera, const WidePinhole& wide) : pose(camera) {
  const auto width = static_cast<double>(wide.width_px), height = static_cast<double>(wide.height_px);
  glm::dmat4 clip(0.0);
  clip[0][0] = 2.0 * wide.fx_px / width;
  clip[2][0] = 2.0 * (wide.cx_px + 0.5) / width - 1.0;
  clip[1][1] = 2.0 * wide.fy_px / height;
  clip[2][1] = 2.0 * (wide.cy_px + 0.5) / height - 1.0;
  clip[3][2] = static_cast<double>(kNear_m);
  clip[2][3] = 1.0;
  clip_from_camera = glm::mat4(clip * glm::dmat4(glm::transpose(camera.R_WC)));
}

bool SceneView::sees(glm::vec3 middle, float reach_m) const {
  const glm::vec4 clip = clip_from_camera * glm::vec4(middle - glm::vec3(pose.p_WC), 1.0F);
  if (clip.w < -reach_m) return false;
  // Rows of the matrix as planes: how far beyond left, right, bottom, top.
  const glm::mat4 rows = glm::transpose(clip_from_camera);
  for (int axis = 0; axis < 2; ++axis) {
    for (const float side : {-1.0F, 1.0F}) {
      const glm::vec4 plane = rows[3] - side * rows[axis];
      if (clip.w - side * clip[axis] < -reach_m * glm::length(glm::vec3(plane))) return false;
    }
  }
  return true;
}

}  // namespace hindsight
