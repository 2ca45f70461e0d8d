// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/sim_run.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "config/exit_code.h"
#include "sim_replay/world/course.h"
#include "tools/verify_command.h"

namespace hindsight::tools {
namespace {

/// A thin trunk straight ahead, between the beams of the infrared sensors: a robot that knows nothing yet
/// runs into it.
constexpr const char* kCourse = R"([course]
name = "one_tree"
length_m = 20.0
width_m = 20.0
ground = "leaf_litter"
[trees]
per_m2 = 0.0
at_m = [7.0, 0.0, 12.0, 4.0, 10.0, -5.0]
radius_min_m = 0.1
radius_max_m = 0.1
)";
constexpr std::uint64_t kSeed = 3;
constexpr int kMostTicks = 200;
/// So many frames earlier, what the bumper touched was well out of its reach.
constexpr int kFramesBack = 10;

SimSetup setup() {
  return {.configuration = {},
          .world = build_world(read_course(ConfigDocument::parse(kCourse, "one_tree.toml")), kSeed),
          .seed = kSeed,
          .mixture = {}};
}

std::string published_by(const SimRun& run) {
  std::string all;
  for (const Outbox::Message& message : run.outbox().messages()) {
    all.append(message.channel);
    all.append(message.bytes.begin(), message.bytes.end());
  }
  return all;
}

TEST(SimRun, OneSeedGivesOneRun) {
  SimRun one(setup()), other(setup());
  for (int tick = 0; tick < 20; ++tick) {
    one.step();
    other.step();
    ASSERT_EQ(one.input().frame->bytes, other.input().frame->bytes) << "tick " << tick;
    ASSERT_EQ(published_by(one), published_by(other)) << "tick " << tick;
  }
  EXPECT_GT(one.summary().distance_m, 0.3);
}

// One run serves both: it is the longest that these tests can afford.
TEST(SimRun, TouchIsTracedBackAndTheLogVerifies) {
  const std::string log = testing::TempDir() + "hindsight_sim_run.lcm";
  SimRun run(setup());
  std::vector<Lesson> touches;
  {
    RunLogWriter writer(log);
    writer.write_header(run.materials());
    for (int tick = 0; tick < kMostTicks && touches.empty(); ++tick) {
      run.step();
      run.record(writer);
      for (const Lesson& lesson : run.robot().learner().lessons()) {
        if (lesson.event.label == TerrainClass::lethal) touches.push_back(lesson);
      }
    }
    ASSERT_TRUE(writer.close());
  }
  EXPECT_EQ(verify_run(log), kExitOk);
  ASSERT_FALSE(touches.empty());
  EXPECT_EQ(run.summary().touches, 1);
  EXPECT_GE(touches.front().traced.frames_back, kFramesBack);
  EXPECT_GT(touches.front().report.pixels, 0);
}

/// The goal lies beyond mud, uphill. The robot tells slip while its wheels slip, soon, and backs out.
TEST(SimRun, SlipIsToldAndBackedOutOf) {
  Course course = load_course(HINDSIGHT_SOURCE_DIR "/sim_replay/courses/slippery_slope.toml");
  course.course.length_m = 20.0;
  course.mud.patches = 1;
  course.mud.from_m = 4.0, course.mud.to_m = 5.0, course.mud.aside_m = 0.0;
  SimRun run({.configuration = {}, .world = build_world(course, kSeed), .seed = kSeed, .mixture = {}});
  std::optional<Time> slipped, told, backed_up;
  for (int tick = 0; tick < kMostTicks && !backed_up; ++tick) {
    run.step(SimFault::none, [&](Time now, const SimVehicle& vehicle, const auto&) {
      // The wheels may spin for an instant as it starts.
      if (!slipped && tick > 20 && vehicle.slipping()) slipped = now;
    });
    const Time now = run.input().now;
    if (!told && run.robot().sensed().slipping) told = now;
    if (run.robot().plan().behaviour == Behaviour::back_up) backed_up = now;
  }
  ASSERT_TRUE(slipped && told && backed_up);
  EXPECT_GE(*told, *slipped);
  EXPECT_LT(to_seconds(*told - *slipped), 1.0);
  EXPECT_LT(to_seconds(*backed_up - *told), 2.5);
}

}  // namespace
}  // namespace hindsight::tools
