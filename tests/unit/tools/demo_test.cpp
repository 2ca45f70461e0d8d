// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "config/exit_code.h"
#include "sim_replay/run_log_writer.h"
#include "tools/demo_run.h"
#include "tools/verify_command.h"

namespace hindsight::tools {
namespace {

/// In this grove the robot soon touches a trunk.
constexpr std::uint64_t kSeed = 2;
constexpr int kMostTicks = 200;
/// So many frames earlier, what the bumper touched was well out of its reach.
constexpr int kFramesBack = 10;

std::string published_by(const DemoRun& run) {
  std::string all;
  for (const Outbox::Message& message : run.outbox().messages()) {
    all.append(message.channel);
    all.append(message.bytes.begin(), message.bytes.end());
  }
  return all;
}

TEST(Demo, OneSeedGivesOneRun) {
  DemoRun one(Configuration{}, kSeed);
  DemoRun other(Configuration{}, kSeed);
  for (int tick = 0; tick < 20; ++tick) {
    one.step();
    other.step();
    ASSERT_EQ(one.input().frame->bytes, other.input().frame->bytes) << "tick " << tick;
    ASSERT_EQ(published_by(one), published_by(other)) << "tick " << tick;
  }
  EXPECT_GT(one.true_pose().x_m, 0.5);
}

TEST(Demo, AnotherSeedGivesAnotherGrove) {
  const DemoWorld one = make_demo_world(25.0, 1);
  const DemoWorld other = make_demo_world(25.0, 2);
  ASSERT_EQ(one.trees.size(), other.trees.size());
  EXPECT_NE(one.trees.front().x_m, other.trees.front().x_m);
}

// One run serves both: it is the longest that these tests can afford.
TEST(Demo, TouchIsTracedBackAndTheLogVerifies) {
  const std::string log = testing::TempDir() + "hindsight_demo.lcm";
  DemoRun run(Configuration{}, kSeed);
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

}  // namespace
}  // namespace hindsight::tools
