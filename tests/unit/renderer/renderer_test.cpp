// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/renderer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "config/exit_code.h"
#include "sim_replay/renderer/camera_pose.h"
#include "sim_replay/renderer/lens.h"
#include "sim_replay/renderer/true_flow.h"

namespace hindsight {
namespace {

/// Looks ahead, a little down, from 0.9 m above the ground.
RenderCamera small_camera() {
  RenderCamera camera;
  camera.width_px = 180, camera.height_px = 120;
  camera.fx_px = camera.fy_px = 105.0;
  camera.cx_px = 89.5, camera.cy_px = 59.5;
  const double down_rad = 0.15;
  camera.R_BC = {0.0, -std::sin(down_rad), std::cos(down_rad), -1.0, 0.0, 0.0,
                 0.0, -std::cos(down_rad), -std::sin(down_rad)};
  camera.p_BC_m = {0.2, 0.0, 0.9};
  return camera;
}

World level_world() {
  World world;
  world.goal = {20.0, 0.0};
  world.trees = {{.at = {6.0, 1.0}, .radius_m = 0.25, .look = 1}, {.at = {9.0, -2.0}, .look = 2}};
  world.bushes = {{.at = {5.0, -1.5}, .look = 3}};
  return world;
}

std::size_t index_of(const RenderCamera& camera, glm::dvec2 px) {
  const auto u = static_cast<std::size_t>(std::lround(px.x)), v = static_cast<std::size_t>(std::lround(px.y));
  return v * static_cast<std::size_t>(camera.width_px) + u;
}

glm::dvec2 px_of(const RenderCamera& camera, const BodyPose& X_WB, glm::dvec3 p_W) {
  const glm::dvec3 p_C = camera_pose(camera, X_WB).to_camera(p_W);
  return distorted_px(camera, {p_C.x / p_C.z, p_C.y / p_C.z});
}

TEST(ARenderer, GivesTheSameBytesForTheSameCalls) {
  std::vector<std::vector<std::uint8_t>> pictures;
  for (int run = 0; run < 2; ++run) {
    Renderer renderer(level_world(), small_camera(), 7);
    renderer.render({}, {}, 0.1, 0.0, run == 0);  // the truth leaves the picture alone
    pictures.push_back(renderer.render({.x_m = 0.1}, {}, 0.1, 0.1, false).bgr);
  }
  EXPECT_EQ(pictures[0], pictures[1]);
}

TEST(ARenderer, DrawsNoiseFromItsSeed) {
  Renderer one(level_world(), small_camera(), 7), other(level_world(), small_camera(), 8);
  EXPECT_NE(one.render({}, {}, 0.1, 0.0, false).bgr, other.render({}, {}, 0.1, 0.0, false).bgr);
}

TEST(ARenderer, KnowsTheDepthOfLevelGround) {
  World world;
  world.goal = {20.0, 0.0};
  for (const double k1 : {0.0, -0.08}) {
    RenderCamera camera = small_camera();
    camera.distortion[0] = k1;
    Renderer renderer(world, camera, 1);
    const BodyPose X_WB{.heading_rad = 0.4, .pitch_rad = 0.05, .roll_rad = 0.1};
    const RenderedFrame& frame = renderer.render(X_WB, X_WB, 0.1, 0.0, true);
    const CameraPose pose = camera_pose(camera, X_WB);
    int compared = 0;
    for (int v = 90; v < 120; ++v) {
      for (int u = 0; u < 180; u += 7) {
        const glm::dvec2 direction = direction_of(camera, {u, v});
        const glm::dvec3 ray = pose.R_WC * glm::dvec3(direction, 1.0);
        const double depth_m = -pose.p_WC.z / ray.z;
        const std::size_t i = index_of(camera, {u, v});
        ASSERT_EQ(frame.labels[i], TruthLabel::ground) << u << " " << v;
        EXPECT_NEAR(static_cast<double>(frame.depth_m[i]), depth_m, 1e-3 * depth_m) << u << ' ' << v;
        ++compared;
      }
    }
    EXPECT_GT(compared, 500);
  }
}

TEST(ARenderer, LabelsWhatStandsThere) {
  const RenderCamera camera = small_camera();
  Renderer renderer(level_world(), camera, 1);
  const RenderedFrame& frame = renderer.render({}, {}, 0.1, 0.0, true);
  const std::size_t trunk = index_of(camera, px_of(camera, {}, {6.0, 1.0, 0.6}));
  EXPECT_EQ(frame.labels[trunk], TruthLabel::tree);
  EXPECT_EQ(frame.objects[trunk], 1);
  EXPECT_NEAR(frame.depth_m[trunk], 5.7, 0.3);
  const std::size_t second = index_of(camera, px_of(camera, {}, {9.0, -2.0, 0.9}));
  EXPECT_EQ(frame.objects[second], 2);
  const std::size_t sky = index_of(camera, {2.0, 2.0});
  EXPECT_EQ(frame.labels[sky], TruthLabel::sky);
  EXPECT_TRUE(std::isinf(frame.depth_m[sky]));
  EXPECT_THAT(frame.objects, testing::Contains(3)) << "the bush";
}

TEST(ARenderer, LabelsTrailsAsRoad) {
  World world;
  world.goal = {20.0, 0.0};
  world.trails = {{.centre = {{0.0, 0.0}, {1.0, 0.0}, {20.0, 0.0}}, .ground = Ground::mulch}};
  const RenderCamera camera = small_camera();
  Renderer renderer(world, camera, 1);
  const RenderedFrame& frame = renderer.render({}, {}, 0.1, 0.0, true);
  EXPECT_EQ(frame.labels[index_of(camera, px_of(camera, {}, {4.0, 0.0, 0.0}))], TruthLabel::road);
  EXPECT_EQ(frame.labels[index_of(camera, px_of(camera, {}, {4.0, 2.0, 0.0}))], TruthLabel::ground);
}

TEST(ARenderer, LeavesTruthEmptyUnasked) {
  Renderer renderer(level_world(), small_camera(), 1);
  renderer.render({}, {}, 0.1, 0.0, true);
  const RenderedFrame& frame = renderer.render({}, {}, 0.1, 0.1, false);
  EXPECT_TRUE(frame.labels.empty() && frame.objects.empty() && frame.depth_m.empty());
}

TEST(ATrueFlow, IsWhereThePointsWere) {
  RenderCamera camera = small_camera();
  camera.distortion = {-0.15, 0.02, 0.001, -0.001};
  const BodyPose now{.x_m = 0.3, .y_m = 0.1, .heading_rad = 0.1, .pitch_rad = 0.02},
      before{.x_m = 0.1, .roll_rad = 0.03};
  Renderer renderer(level_world(), camera, 1);
  const RenderedFrame& frame = renderer.render(now, before, 0.1, 0.0, true);
  const FlowTruth flow = TrueFlow(camera).of(frame.depth_m, now, before);
  for (const glm::dvec3 p_W : {glm::dvec3(3.0, 0.2, 0.0), {4.0, 1.0, 0.0}, {2.5, -0.5, 0.0}}) {
    const glm::dvec2 px = px_of(camera, now, p_W), was = px_of(camera, before, p_W);
    const std::size_t i = index_of(camera, px);
    const glm::dvec2 rest = px - glm::round(px);  // the pixel's middle shows a neighbour of the point
    EXPECT_NEAR(static_cast<double>(flow.u_before_px[i]), was.x - rest.x, 0.15);
    EXPECT_NEAR(static_cast<double>(flow.v_before_px[i]), was.y - rest.y, 0.15);
  }
  EXPECT_TRUE(std::isnan(flow.u_before_px[index_of(camera, {2.0, 2.0})]));
}

TEST(ARenderer, SaysThatThereIsNoEgl) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // a process that has not loaded EGL yet
  EXPECT_EXIT(
      {
        setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1);
        try {
          Renderer renderer(level_world(), small_camera(), 1);
        } catch (const FatalError& error) {
          std::fputs(error.what(), stderr);
          std::exit(error.code());
        }
        std::exit(0);
      },
      testing::ExitedWithCode(kExitNoDevice), "no EGL");
}

}  // namespace
}  // namespace hindsight
