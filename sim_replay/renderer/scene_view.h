// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <glm/glm.hpp>

#include "sim_replay/renderer/camera_pose.h"
#include "sim_replay/renderer/lens.h"

namespace hindsight {

/// Nearer things are cut off.
constexpr float kNear_m = 0.05F;

/// Light at one moment, linear.
struct SceneLight {
  glm::vec3 to_sun;
  glm::vec3 sun, sky;         ///< on what faces it
  glm::vec3 haze;             ///< of air far away
  glm::vec3 horizon, zenith;  ///< of the sky itself
  float haze_per_m;
  float clouds;
};

glm::vec3 to_sun_of(const Light& light);
SceneLight scene_light(const Light& light, double time_s);

/// One picture's geometry: from places relative to the camera (W's axes) to the wide picture, whose first row
/// is the top. Depth is stored as near / depth, so that 0 is infinity.
struct SceneView {
  CameraPose pose;
  glm::mat4 clip_from_camera;

  SceneView(const CameraPose& camera, const WidePinhole& wide);
  bool sees(glm::vec3 middle, float reach_m) const;
};

}  // namespace hindsight
