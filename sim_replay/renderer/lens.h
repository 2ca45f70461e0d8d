// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "sim_replay/renderer/renderer.h"

namespace hindsight {

/// Pixel at which OpenCV's model shows the direction (x, y, 1) of C.
glm::dvec2 distorted_px(const RenderCamera& camera, glm::dvec2 direction);

/// Direction (x, y, 1) that a pixel looks in: the inverse, by Newton's method.
glm::dvec2 direction_of(const RenderCamera& camera, glm::dvec2 px);

/// A pinhole without distortion that sees at least what the camera sees, equally fine in the middle.
struct WidePinhole {
  int width_px = 0;
  int height_px = 0;
  double fx_px = 0.0, fy_px = 0.0, cx_px = 0.0, cy_px = 0.0;

  glm::dvec2 px(glm::dvec2 direction) const {
    return {fx_px * direction.x + cx_px, fy_px * direction.y + cy_px};
  }
};

/// What each pixel of the camera looks at.
struct Lens {
  std::vector<glm::vec2> directions;  ///< row by row
  std::vector<glm::vec2> sources_px;  ///< where that is in the wide picture
  WidePinhole wide;

  explicit Lens(const RenderCamera& camera);
};

}  // namespace hindsight
