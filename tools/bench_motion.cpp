// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/bench_motion.h"

#include <vector>

#include "tools/aerial_flight.h"
#include "tools/cpu_time.h"
#include "tools/video_tracker.h"

namespace hindsight::tools {
namespace {

constexpr std::uint64_t kSeed = 5;
constexpr int kFrames = 60;

}  // namespace

double bench_motion_fps() {
  const AerialWorld world = make_aerial_world(kSeed);
  AerialRenderer renderer(world);
  AerialFlight flight(renderer, AerialCamera(kSeed, {0, 0}, 38.0, 0.0, 0.1),
                      AerialTraffic(world, kSeed, 40.0, 40, {}), 20.0);
  VideoTracker tracker(MotionParams{}, {AerialCamera::kWidth_px, AerialCamera::kHeight_px});
  std::vector<double> us;
  for (int i = 0; i < kFrames; ++i) {
    const auto vectors = flight.step();
    us.push_back(microseconds([&] { tracker.step(vectors, Eigen::Matrix3d::Identity()); }));
  }
  return 1e6 / quantile(us, 0.5);
}

}  // namespace hindsight::tools
