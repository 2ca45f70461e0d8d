// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// An operator rehearses faults on a recorded run: the robot's answer to each is that which it gives under
// way.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <map>

#include "daemon/replay_run.h"
#include "sim_replay/world/course.h"
#include "tools/sim_run.h"

namespace hindsight::tools {
namespace {

std::string recorded_drive() {
  const std::string path =
      std::filesystem::temp_directory_path() / ("replay_faults_" + std::to_string(::getpid()) + ".lcm");
  const Course course =
      load_course(std::string(HINDSIGHT_SOURCE_DIR) + "/sim_replay/courses/desert_road.toml");
  SimRun run({.configuration = {}, .world = build_world(course, 1), .seed = 1, .mixture = {}});
  RunLogWriter writer(path);
  writer.write_header(run.materials());
  for (int i = 0; i < 40; ++i) {
    run.step();
    run.record(writer);
  }
  EXPECT_TRUE(writer.close());
  return path;
}

TEST(ReplayFaults, EachFaultStopsTheVehicleForItsReason) {
  const std::string log = recorded_drive();
  const std::map<std::string, StopReason> expected{
      {"camera:off:2s:1.5s", StopReason::camera}, {"camera:garbage:2s:1.5s", StopReason::camera},
      {"can:off:2s:1.5s", StopReason::wheels},    {"can:garbage:2s:1.5s", StopReason::wheels},
      {"can:stuck:2s:1.5s", StopReason::wheels},  {"gpio:off:2s:1.5s", StopReason::gpio},
      {"gps:off:2s:1.5s", StopReason::none},      {"gps:wrong:2s:1.5s", StopReason::none}};
  for (const auto& [fault, reason] : expected) {
    ReplayRun run(log, std::nullopt, false, {parse_fault(fault)});
    bool drove = false;
    for (int i = 0; run.step(); ++i) {
      if (i == 19) drove = run.decision().reason == StopReason::none && run.decision().command.left_mps > 0.0;
    }
    EXPECT_TRUE(drove) << fault << ": before it came";
    EXPECT_EQ(run.decision().reason, reason) << fault;
  }
  std::filesystem::remove(log);
}

TEST(ReplayFaults, WithoutFaultsTheReplayIsTheRun) {
  const std::string log = recorded_drive();
  ReplayRun run(log, std::nullopt, false);
  int ticks = 0;
  while (run.step()) {
    ++ticks;
    ASSERT_EQ(run.recorded().size(), run.outbox().messages().size());
  }
  EXPECT_EQ(ticks, 40);
  std::filesystem::remove(log);
}

}  // namespace
}  // namespace hindsight::tools
