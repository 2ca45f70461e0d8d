// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/camera_pose.h"

#include <cmath>

namespace hindsight {
namespace {

// glm's matrices are written column by column.
glm::dmat3 about_x(double a) {
  return {1.0, 0.0, 0.0, 0.0, std::cos(a), std::sin(a), 0.0, -std::sin(a), std::cos(a)};
}
glm::dmat3 about_y(double a) {
  return {std::cos(a), 0.0, -std::sin(a), 0.0, 1.0, 0.0, std::sin(a), 0.0, std::cos(a)};
}
glm::dmat3 about_z(double a) {
  return {std::cos(a), std::sin(a), 0.0, -std::sin(a), std::cos(a), 0.0, 0.0, 0.0, 1.0};
}

}  // namespace

glm::dmat3 rotation_WB(const BodyPose& X_WB) {
  return about_z(X_WB.heading_rad) * about_y(X_WB.pitch_rad) * about_x(X_WB.roll_rad);
}

CameraPose camera_pose(const RenderCamera& camera, const BodyPose& X_WB) {
  const std::array<double, 9>& r = camera.R_BC;
  const glm::dmat3 R_BC(r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]);
  const glm::dmat3 R_WB = rotation_WB(X_WB);
  const glm::dvec3 p_BC(camera.p_BC_m[0], camera.p_BC_m[1], camera.p_BC_m[2]);
  return {R_WB * R_BC, R_WB * p_BC + glm::dvec3(X_WB.x_m, X_WB.y_m, X_WB.z_m)};
}

}  // namespace hindsight
