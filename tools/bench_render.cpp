// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/bench_render.h"

#include <cmath>
#include <vector>

#include "daemon/run_setup.h"
#include "sim_replay/world/course.h"
#include "tools/builtin_config.h"
#include "tools/cpu_time.h"
#include "tools/sim_feed.h"
#include "tools/sim_run.h"

namespace hindsight::tools {
namespace {

constexpr std::uint64_t kSeed = 5;
constexpr int kFrames = 60;
constexpr double kInterval_s = 0.1;
constexpr double kStep_m = 0.1;

/// At a share of the straight way to the goal, and back_m before it.
BodyPose pose_at(const World& world, double share, double back_m) {
  const double x_m = world.goal.x_m - world.start.x_m, y_m = world.goal.y_m - world.start.y_m;
  const double way_m = share * std::hypot(x_m, y_m) - back_m, heading_rad = std::atan2(y_m, x_m);
  const WorldPoint at{world.start.x_m + way_m * std::cos(heading_rad),
                      world.start.y_m + way_m * std::sin(heading_rad)};
  return {.x_m = at.x_m, .y_m = at.y_m, .z_m = world.terrain.height_m(at), .heading_rad = heading_rad};
}

}  // namespace

double bench_render_fps() {
  const World world = build_world(forest_course(), kSeed);
  const Configuration configuration;
  const RobotSetup setup = make_setup(configuration, sim_materials(configuration, {}), "simulation");
  Renderer renderer(world, render_camera(setup.camera), kSeed);
  std::vector<double> cpu_s;
  for (int i = 0; i < kFrames; ++i) {
    const double share = static_cast<double>(i) / kFrames, begin_s = process_cpu_s();
    renderer.render(pose_at(world, share, 0.0), pose_at(world, share, kStep_m), kInterval_s, i * kInterval_s,
                    false);
    cpu_s.push_back(process_cpu_s() - begin_s);
  }
  return 1.0 / quantile(cpu_s, 0.5);
}

}  // namespace hindsight::tools
