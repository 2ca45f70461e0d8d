// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/slip_camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_replay/world/course.h"
#include "tools/slip_drive.h"

namespace hindsight::tools {
namespace {

constexpr std::uint64_t kSeed = 5001;

World slope(const char* ground, int mud_patches) {
  Course course = load_course(HINDSIGHT_SOURCE_DIR "/sim_replay/courses/slippery_slope.toml");
  course.course.ground = ground;
  course.mud.patches = mud_patches;
  return build_world(course, kSeed);
}

TEST(SlipCamera, MeasuresTheWayOverRenderedGround) {
  for (const char* ground : {"leaf_litter", "road"}) {
    const World world = slope(ground, 0);
    SlipTrace trace = drive_for_slip(Configuration{}, world, kSeed, 4.0);
    const std::vector<SlipSpan> all{{trace.begin, trace.ticks.back().now}};
    look_at_ground(Configuration{}, world, kSeed, all, trace);
    ASSERT_EQ(trace.steps.size(), trace.ticks.size() - 2) << ground;
    const std::vector<StepError> errors = step_errors(trace);
    ASSERT_EQ(errors.size(), trace.steps.size()) << ground;
    for (const StepError& error : errors) {
      EXPECT_TRUE(error.valid) << ground;
      EXPECT_LT(std::abs(error.forward_m), 0.015) << ground;
      EXPECT_LT(std::abs(error.turn_rad), 0.015) << ground;
    }
    EXPECT_GT(trace.steps.back().motion.forward_m, 0.05) << ground << ": it drives";
  }
}

TEST(SlipCamera, FeedsTheErrorsThatItWasGiven) {
  SlipTrace trace = drive_for_slip(Configuration{}, slope("soil", 0), kSeed, 10.0);
  const std::vector<StepError> given{{true, 0.01, 0.0}, {true, -0.02, 0.1}, {false, 0.0, 0.0}};
  feed_steps(given, kSeed, trace);
  const std::vector<StepError> found = step_errors(trace);
  ASSERT_EQ(found.size(), trace.ticks.size() - 1);
  const auto first = std::find_if(found.begin(), found.end(), [](const StepError& e) { return !e.valid; });
  for (auto it = first; it - first < 30; ++it) {
    const StepError& as = given[static_cast<std::size_t>(it - first + 2) % given.size()];
    EXPECT_EQ(it->valid, as.valid);
    EXPECT_NEAR(it->forward_m, as.forward_m, 1e-12);
    EXPECT_NEAR(it->turn_rad, as.turn_rad, 1e-12);
  }
}

TEST(SlipCamera, SlipIsToldWithinASecond) {
  const World world = slope("soil", 7);
  SlipTrace trace = drive_for_slip(Configuration{}, world, kSeed, 9.0);
  const std::vector<SlipSpan> slips = trace.fresh_slips();
  ASSERT_FALSE(slips.empty());
  const std::vector<SlipSpan> when{{slips[0].begin - from_seconds(1.0), slips[0].begin + from_seconds(1.5)}};
  look_at_ground(Configuration{}, world, kSeed, when, trace);
  SlipScore score;
  score_slip({}, RobotParams{}.current_rate_hz, VehicleParams{}.track_width_m, trace, score);
  ASSERT_EQ(score.slips.size(), 1U);
  EXPECT_LT(score.slips[0].delay_s, 0.8);
  EXPECT_EQ(score.false_alarms, 0);
}

}  // namespace
}  // namespace hindsight::tools
