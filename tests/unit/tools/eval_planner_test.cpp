// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "config/exit_code.h"
#include "tools/bucket_astar.h"
#include "tools/eval_planner_command.h"
#include "tools/movingai.h"

namespace hindsight::tools {
namespace {

constexpr const char* kMap = "type octile\nheight 3\nwidth 4\nmap\n....\n.@T.\nG..S\n";

class PlannerFiles : public testing::Test {
 protected:
  PlannerFiles()
      : folder_(std::filesystem::temp_directory_path() /
                ("hindsight_planner_" +
                 std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~PlannerFiles() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  void expect_error(ExitCode code, const std::string& part) {
    try {
      evaluate_planner(folder_, 0);
      ADD_FAILURE() << "expected an error with " << part;
    } catch (const FatalError& error) {
      EXPECT_EQ(error.code(), code);
      EXPECT_THAT(error.what(), testing::HasSubstr(part));
    }
  }
  void expect_scenario_error(const std::string& line, const std::string& part) {
    write("a.map", kMap);
    write("a.map.scen", "version 1\n0\ta.map\t4\t3\t0\t0\t3\t0\t3\n" + line);
    expect_error(kExitBadData, part);
  }

  std::filesystem::path folder_;
};

TEST_F(PlannerFiles, ProblemsAreSolvedAndCounted) {
  write("a.map", kMap);
  write("a.map.scen",
        "version "
        "1\n0\ta.map\t4\t3\t0\t0\t3\t0\t3\n0\ta.map\t4\t3\t0\t0\t3\t2\t5\n0\ta.map\t4\t3\t0\t0\t1\t1\t0\n");
  const PlannerEvaluation result = evaluate_planner(folder_, 0);
  EXPECT_EQ(result.maps, 1);
  EXPECT_EQ(result.problems, 3);
  EXPECT_EQ(result.optimal, 3) << "the third is unreachable and the file says so";
  EXPECT_EQ(evaluate_planner(folder_, 2).problems, 2);
}

TEST_F(PlannerFiles, AWrongLengthIsNotOptimal) {
  write("a.map", kMap);
  write("a.map.scen", "version 1\n0\ta.map\t4\t3\t0\t0\t3\t0\t2.9\n0\ta.map\t4\t3\t0\t0\t3\t0\t3\n");
  EXPECT_EQ(evaluate_planner(folder_, 0).optimal, 1);
}

TEST_F(PlannerFiles, MissingFolderOrFiles) {
  expect_error(kExitNoInput, "at least one .map");
  write("a.map", kMap);
  expect_error(kExitNoInput, "a.map.scen");
  std::filesystem::remove_all(folder_);
  expect_error(kExitNoInput, folder_.string());
}

TEST_F(PlannerFiles, DamagedMapsAreNamedWithTheirLine) {
  write("a.map", "type tile\n");
  expect_error(kExitBadData, "a.map:1: expected 'type octile'");
  write("a.map", "type octile\nheight -3\n");
  expect_error(kExitBadData, "a.map:2: expected 'height N'");
  write("a.map", "type octile\nheight 2\nwidth 3\nmap\n...\n..\n");
  expect_error(kExitBadData, "a.map:6: expected a row of 3 cells");
  write("a.map", "type octile\nheight 1\nwidth 3\nmap\n.x.\n");
  expect_error(kExitBadData, "a.map:5: expected only cells");
}

TEST_F(PlannerFiles, DamagedScenariosAreNamedWithTheirLine) {
  expect_scenario_error("0\ta.map\t4\t3\t0\t0\n", "a.map.scen:3: expected bucket");
  expect_scenario_error("0\ta.map\t4\t4\t0\t0\t3\t0\t3\n", "a.map.scen:3: expected the map's size, 4 x 3");
  expect_scenario_error("0\ta.map\t4\t3\t0\t0\t4\t0\t3\n", "a.map.scen:3: expected start and goal inside");
}

TEST(PlannerOnData, MovingAiProblemsAreSolvedOptimally) {
  const char* data = std::getenv("HINDSIGHT_DATA");
  if (data == nullptr) GTEST_SKIP() << "no data";
  const PlannerEvaluation result = evaluate_planner(std::filesystem::path(data) / "grids_movingai_dao", 1000);
  EXPECT_EQ(result.problems, 1000);
  EXPECT_EQ(result.optimal, result.problems);
}

TEST(BucketAstar, FindsTheShortestWayAndNoWay) {
  BucketAstar astar(3, 3);
  EXPECT_EQ(astar.search(0, 8), 2 * 1154U);
  astar.set_cost(4, kLethalCost);
  EXPECT_EQ(astar.search(0, 8), 4 * kCellUnit);
  astar.set_cost(1, kLethalCost);
  astar.set_cost(3, kLethalCost);
  EXPECT_EQ(astar.search(0, 8), kUnreachable);
}

}  // namespace
}  // namespace hindsight::tools
