// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/lens.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

RenderCamera bent_camera() {
  RenderCamera camera;
  camera.distortion = {-0.28, 0.09, 0.0007, -0.0004, -0.012, 0.0, 0.0, 0.0};
  camera.R_BC = {0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0};
  camera.p_BC_m = {0.0, 0.0, 1.0};
  return camera;
}

TEST(ALens, InvertsItsDistortion) {
  const RenderCamera camera = bent_camera();
  for (int v = 0; v < camera.height_px; v += 31) {
    for (int u = 0; u < camera.width_px; u += 31) {
      const glm::dvec2 back = distorted_px(camera, direction_of(camera, {u, v}));
      EXPECT_NEAR(back.x, u, 1e-6);
      EXPECT_NEAR(back.y, v, 1e-6);
    }
  }
}

// OpenCV's documentation, "Camera Calibration and 3D Reconstruction", written out once more.
TEST(ALens, FollowsOpenCvsFormula) {
  const RenderCamera camera = bent_camera();
  const double x = 0.5, y = -0.3, r2 = x * x + y * y;
  const double radial = 1.0 - 0.28 * r2 + 0.09 * r2 * r2 - 0.012 * r2 * r2 * r2;
  const double u = x * radial + 2.0 * 0.0007 * x * y - 0.0004 * (r2 + 2.0 * x * x);
  const double v = y * radial + 0.0007 * (r2 + 2.0 * y * y) + 2.0 * -0.0004 * x * y;
  const glm::dvec2 px = distorted_px(camera, {x, y});
  EXPECT_NEAR(px.x, 420.0 * u + 359.5, 1e-9);
  EXPECT_NEAR(px.y, 420.0 * v + 239.5, 1e-9);
}

/// Column at which the object's pixels begin in a row; between two pixels.
double left_edge_px(const RenderedFrame& frame, int width_px, int row, std::uint16_t object) {
  const auto first = frame.objects.begin() + row * width_px, last = first + width_px;
  return static_cast<double>(std::find(first, last, object) - first) - 0.5;
}

TEST(ALens, BendsTheRenderedPictureByTheFormula) {
  World world;
  world.goal = {20.0, 0.0};
  world.trees = {{.at = {4.0, 2.4}, .radius_m = 0.2, .height_m = 12.0, .crown_base_m = 9.0, .look = 4}};
  const RenderCamera bent = bent_camera();
  RenderCamera straight = bent;
  straight.distortion = {};
  Renderer bent_renderer(world, bent, 1), straight_renderer(world, straight, 1);
  const RenderedFrame& bent_frame = bent_renderer.render({}, {}, 0.1, 0.0, true);
  const RenderedFrame& straight_frame = straight_renderer.render({}, {}, 0.1, 0.0, true);
  double sum_px = 0.0;
  constexpr int kFrom = 150, kTo = 300;
  for (int row = kFrom; row < kTo; ++row) {
    const glm::dvec2 direction = direction_of(bent, {left_edge_px(bent_frame, bent.width_px, row, 1), row});
    const glm::dvec2 px = distorted_px(straight, direction);
    sum_px += px.x - left_edge_px(straight_frame, straight.width_px, static_cast<int>(std::lround(px.y)), 1);
  }
  EXPECT_NEAR(sum_px / (kTo - kFrom), 0.0, 0.3);
}

}  // namespace
}  // namespace hindsight
