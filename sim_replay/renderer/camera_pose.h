// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <glm/glm.hpp>

#include "sim_replay/renderer/renderer.h"

namespace hindsight {

/// Where the camera is: p_W = R_WC p_C + p_WC.
struct CameraPose {
  glm::dmat3 R_WC{1.0};
  glm::dvec3 p_WC{0.0};

  glm::dvec3 to_camera(glm::dvec3 p_W) const { return glm::transpose(R_WC) * (p_W - p_WC); }
  glm::dvec3 to_world(glm::dvec3 p_C) const { return R_WC * p_C + p_WC; }
};

glm::dmat3 rotation_WB(const BodyPose& X_WB);
CameraPose camera_pose(const RenderCamera& camera, const BodyPose& X_WB);

}  // namespace hindsight
