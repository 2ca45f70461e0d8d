// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/track_csv.h"

#include "tests/unit/sim_replay/log_test_support.h"

namespace hindsight {
namespace {

using namespace test;

class TrackCsvTest : public testing::Test {
 protected:
  std::vector<TrackRow> read(const std::string& text) {
    write_text(path_, text);
    TrackCsv track(path_);
    std::vector<TrackRow> rows(1);
    while (track.next(rows.back())) rows.emplace_back();
    rows.pop_back();
    return rows;
  }
  void expect_error(const std::string& text, const std::string& message) {
    EXPECT_THAT(fatal_message(kExitBadData, [&] { read(text); }), testing::HasSubstr("track.csv:" + message))
        << text;
  }

  TempFolder folder_;
  std::filesystem::path path_ = folder_ / "track.csv";
};

TEST_F(TrackCsvTest, ReadsEveryColumnInAnyOrderAndLeavesEmptyCellsEmpty) {
  const auto rows = read(
      "\xEF\xBB\xBF left_mps,time_s,right_mps,left_a,right_a,ir_left_m,ir_right_m,yaw_rate_radps,bumper_left,"
      "bumper_right,estop,latitude_deg,longitude_deg,goal_east_m,goal_north_m,arm\r\n"
      "# a remark\n"
      "\n"
      "0.5,-0.25,0.6,1.5,-1.6,0.7,0.8,0.01,1,0,0,47.5,8.25,10,-20,1\r\n"
      ", 1e1 ,,,,,,,,,,,,,,\n");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].time_s, -0.25);
  EXPECT_EQ(rows[0].left_mps, 0.5);
  EXPECT_EQ(rows[0].right_mps, 0.6);
  EXPECT_EQ(rows[0].left_a, 1.5);
  EXPECT_EQ(rows[0].right_a, -1.6);
  EXPECT_EQ(rows[0].ir_left_m, 0.7);
  EXPECT_EQ(rows[0].ir_right_m, 0.8);
  EXPECT_EQ(rows[0].yaw_rate_radps, 0.01);
  EXPECT_EQ(rows[0].bumper_left, 1.0);
  EXPECT_EQ(rows[0].bumper_right, 0.0);
  EXPECT_EQ(rows[0].estop, 0.0);
  EXPECT_EQ(rows[0].latitude_deg, 47.5);
  EXPECT_EQ(rows[0].longitude_deg, 8.25);
  EXPECT_EQ(rows[0].goal_east_m, 10.0);
  EXPECT_EQ(rows[0].goal_north_m, -20.0);
  EXPECT_EQ(rows[0].arm, 1.0);
  EXPECT_EQ(rows[1].time_s, 10.0);
  EXPECT_FALSE(rows[1].left_mps || rows[1].estop || rows[1].latitude_deg || rows[1].goal_east_m ||
               rows[1].arm);
}

TEST_F(TrackCsvTest, NamesFileLineAndColumnOfEveryMistake) {
  expect_error("", " the track is empty");
  expect_error("left_mps,right_mps\n", "1:time_s: the column is missing");
  expect_error("time_s,speed\n", "1:speed: no such column");
  expect_error("# remark\ntime_s,arm,arm\n", "2:arm: named twice");
  expect_error("time_s,arm\n0\n", "2: 1 cells where the first line names 2 columns");
  expect_error("time_s,left_mps\n0,1\n1,fast\n", "3:left_mps: 'fast' is not a number");
  expect_error("time_s,left_mps\n0,1 2\n", "2:left_mps: '1 2' is not a number");
  expect_error("time_s,left_mps\n0,nan\n", "2:left_mps: 'nan' is not a number");
  expect_error("time_s,left_mps\n0,1e999\n", "2:left_mps: '1e999' is not a number");
  expect_error("time_s,left_mps\n,1\n", "2:time_s: '' is not a number");
  expect_error("time_s\n1\n0.5\n", "3:time_s: time goes back from 1 to 0.5");
  expect_error("time_s\n1700000000\n", "2:time_s: 1700000000 is no time in seconds");
  expect_error("time_s,bumper_left\n0,0.5\n", "2:bumper_left: 0.5 is neither 0 nor 1");
  expect_error("time_s,latitude_deg,longitude_deg\n0,91,0\n", "2:latitude_deg: 91 is beyond 90 degrees");
  expect_error("time_s,latitude_deg,longitude_deg\n0,1,\n", "2:latitude_deg: a fix needs both coordinates");
  expect_error("time_s,goal_north_m\n0,1\n", "2:goal_east_m: a goal needs both coordinates");
}

TEST_F(TrackCsvTest, IsAbsent) {
  EXPECT_THAT(fatal_message(kExitNoInput, [&] { TrackCsv(folder_ / "none.csv"); }),
              testing::HasSubstr("none.csv: cannot open the track"));
}

}  // namespace
}  // namespace hindsight
