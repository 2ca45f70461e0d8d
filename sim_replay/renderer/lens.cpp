// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/lens.h"

#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

/// No lens of ours bends more: beyond it the pixels at the rim go without a scene of their own.
constexpr double kWidest = 1.7;

glm::dvec2 distorted(const std::array<double, 8>& d, glm::dvec2 p) {
  const double r2 = p.x * p.x + p.y * p.y;
  const double radial =
      (1.0 + r2 * (d[0] + r2 * (d[1] + r2 * d[4]))) / (1.0 + r2 * (d[5] + r2 * (d[6] + r2 * d[7])));
  return {p.x * radial + 2.0 * d[2] * p.x * p.y + d[3] * (r2 + 2.0 * p.x * p.x),
          p.y * radial + d[2] * (r2 + 2.0 * p.y * p.y) + 2.0 * d[3] * p.x * p.y};
}

/// Whole pixels that the wide picture needs before the camera's first, and after its last.
int margin_px(double beyond_px, int size_px) {
  return static_cast<int>(std::ceil(std::clamp(beyond_px, 0.0, 0.5 * (kWidest - 1.0) * size_px)));
}

}  // namespace

glm::dvec2 distorted_px(const RenderCamera& camera, glm::dvec2 direction) {
  const glm::dvec2 p = distorted(camera.distortion, direction);
  return {camera.fx_px * p.x + camera.cx_px, camera.fy_px * p.y + camera.cy_px};
}

glm::dvec2 direction_of(const RenderCamera& camera, glm::dvec2 px) {
  const glm::dvec2 wanted((px.x - camera.cx_px) / camera.fx_px, (px.y - camera.cy_px) / camera.fy_px);
  constexpr double h = 1e-6;
  glm::dvec2 p = wanted;
  for (int i = 0; i < 12; ++i) {
    const glm::dvec2 now = distorted(camera.distortion, p);
    const glm::dmat2 slope((distorted(camera.distortion, p + glm::dvec2(h, 0.0)) - now) / h,
                           (distorted(camera.distortion, p + glm::dvec2(0.0, h)) - now) / h);
    p += glm::inverse(slope) * (wanted - now);
  }
  return p;
}

Lens::Lens(const RenderCamera& camera) {
  glm::dvec2 low(0.0), high(camera.width_px - 1, camera.height_px - 1);
  for (int v = 0; v < camera.height_px; ++v) {
    for (int u = 0; u < camera.width_px; ++u) {
      const glm::dvec2 direction = direction_of(camera, {u, v});
      directions.emplace_back(direction);
      const glm::dvec2 px(camera.fx_px * direction.x + camera.cx_px,
                          camera.fy_px * direction.y + camera.cy_px);
      low = glm::min(low, px);
      high = glm::max(high, px);
    }
  }
  const int left = margin_px(-low.x - 1e-6, camera.width_px),
            top = margin_px(-low.y - 1e-6, camera.height_px);
  const int right = margin_px(high.x - camera.width_px + 1 - 1e-6, camera.width_px);
  const int bottom = margin_px(high.y - camera.height_px + 1 - 1e-6, camera.height_px);
  wide = {left + camera.width_px + right,
          top + camera.height_px + bottom,
          camera.fx_px,
          camera.fy_px,
          camera.cx_px + left,
          camera.cy_px + top};
  for (const glm::vec2& direction : directions) sources_px.emplace_back(wide.px(direction));
}

}  // namespace hindsight
