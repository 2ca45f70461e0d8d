// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/eval_slip_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "config/exit_code.h"
#include "tools/eval_command.h"
#include "tools/motor_csv.h"

namespace hindsight::tools {
namespace {

std::string write_csv(const std::string& name, const std::string& text) {
  const std::string path = testing::TempDir() + "hindsight_eval_slip_" + name + ".csv";
  std::ofstream(path) << text;
  return path;
}

/// One minute at 15 Hz; the left motor oscillates at 3 Hz for 5 s from each of the times given.
std::string recording(const std::string& header, const std::vector<double>& slips_s) {
  std::string text = header + "\n";
  for (int i = 0; i < 900; ++i) {
    const double t = i / 15.0;
    double left_a = 4.0 + 0.3 * std::sin(1.0 * t);
    for (const double from : slips_s) {
      if (t >= from && t < from + 5.0) left_a += 4.0 * std::sin(2.0 * M_PI * 3.0 * t);
    }
    text += std::to_string(t) + "," + std::to_string(left_a) + ",4.0,0.5,0.5\n";
  }
  return text;
}

nlohmann::json eval_json(const std::vector<std::string>& files, const std::string& rate) {
  CLI::App app;
  Run run;
  add_eval(app, run);
  std::string arguments = "eval slip --json --rate " + rate + " --csv";
  for (const std::string& file : files) arguments += " " + file;
  app.parse(arguments);
  testing::internal::CaptureStdout();
  const int code = run();
  const std::string out = testing::internal::GetCapturedStdout();
  EXPECT_EQ(code, kExitOk);
  return nlohmann::json::parse(out);
}

FatalError error_of(const std::string& path, const std::vector<std::string>& columns) {
  try {
    read_motor_csv(path, columns);
  } catch (const FatalError& error) {
    return error;
  }
  return {kExitOk, "no error"};
}

TEST(EvalSlip, CountsRisingEdges) {
  const std::string header = "time,curL,curR,velL,velR";
  const nlohmann::json two = eval_json({write_csv("two", recording(header, {10.0, 30.0}))}, "15");
  EXPECT_EQ(two["detections"], 2);
  EXPECT_NEAR(two["hours"].get<double>(), 1.0 / 60.0, 1e-12);
  EXPECT_NEAR(two["per_hour"].get<double>(), 120.0, 1e-6);
  EXPECT_GE(two["thesis"]["detections"].get<int>(), 2);
  EXPECT_EQ(two["thesis"]["hours"], two["hours"]);
  const nlohmann::json none = eval_json({write_csv("none", recording(header, {}))}, "15");
  EXPECT_EQ(none["detections"], 0);
  EXPECT_EQ(none["thesis"]["detections"], 0);
}

TEST(EvalSlip, AddsUpFiles) {
  const std::string header = "time,curL,curR,velL,velR";
  const std::string path = write_csv("sum", recording(header, {20.0}));
  const nlohmann::json sum = eval_json({path, path, path}, "15");
  EXPECT_EQ(sum["detections"], 3);
  EXPECT_NEAR(sum["hours"].get<double>(), 0.05, 1e-12);
}

TEST(EvalSlip, WithoutSpeedsTakesTheWheelsToTurn) {
  const nlohmann::json result =
      eval_json({write_csv("blind", recording("time,curL,curR,a,b", {20.0}))}, "15");
  EXPECT_EQ(result["detections"], 1);
}

TEST(EvalSlip, FalseAlarmsOnRecordedDriving) {
  const char* data = std::getenv("HINDSIGHT_DATA");
  if (data == nullptr) GTEST_SKIP() << "no data";
  std::vector<std::string> files;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::string(data) + "/logs/motor/vulpi")) {
    if (entry.path().filename().string().starts_with("pro_")) files.push_back(entry.path());
  }
  ASSERT_FALSE(files.empty());
  const nlohmann::json result = eval_json(files, "15");
  EXPECT_LT(result["per_hour"].get<double>(), 20.0);
  EXPECT_LE(result["per_hour"].get<double>(), result["thesis"]["per_hour"].get<double>());
}

TEST(MotorCsv, FindsColumnsByName) {
  for (const char* header :
       {"time,curL,curR,velL,velR", "t, Left Current, Right Current, left_speed, right_speed",
        "time,current_left,current_right,vel_l,vel_r"}) {
    const MotorRecording recording =
        read_motor_csv(write_csv("names", std::string(header) + "\r\n0,1,2, 3,4\r\n"), {});
    ASSERT_EQ(recording.samples.size(), 1U) << header;
    EXPECT_TRUE(recording.has_speeds);
    EXPECT_EQ(recording.samples[0].left_a, 1.0);
    EXPECT_EQ(recording.samples[0].right_a, 2.0);
    EXPECT_EQ(recording.samples[0].left_mps, 3.0);
    EXPECT_EQ(recording.samples[0].right_mps, 4.0);
  }
}

TEST(MotorCsv, TakesTheColumnsNamed) {
  const std::string path = write_csv("columns", "a,b,c,curL,curR\n1,2,3,4,5\n");
  const MotorRecording recording = read_motor_csv(path, {"c", "a"});
  EXPECT_FALSE(recording.has_speeds);
  EXPECT_EQ(recording.samples[0].left_a, 3.0);
  EXPECT_EQ(recording.samples[0].right_a, 1.0);
}

TEST(MotorCsv, NamesTheFileThatIsMissing) {
  const FatalError error = error_of("/nowhere/motor.csv", {});
  EXPECT_EQ(error.code(), kExitNoInput);
  EXPECT_STREQ(error.what(), "/nowhere/motor.csv: cannot be read; expected a CSV file");
  EXPECT_EQ(error_of("/", {}).code(), kExitNoInput);
}

TEST(MotorCsv, NamesThePlaceOfWhatIsMalformed) {
  const auto expect = [](const std::string& text, const std::vector<std::string>& columns,
                         const std::string& message) {
    const std::string path = write_csv("bad", text);
    const FatalError error = error_of(path, columns);
    EXPECT_EQ(error.code(), kExitBadData);
    EXPECT_EQ(error.what(), path + message);
  };
  expect("curL,curR\n1,2\n1,x\n", {}, ":3: right current in column 2 is \"x\"; expected a finite number");
  expect("curL,curR\n1\n", {}, ":2: right current in column 2 is \"\"; expected a finite number");
  expect("curL,curR\nnan,1\n", {}, ":2: left current in column 1 is \"nan\"; expected a finite number");
  expect("curL,curR\n1,2\n\n", {}, ":3: left current in column 1 is \"\"; expected a finite number");
  expect("curL,b\n1,2\n", {},
         ":1: right current: expected a column for it; name it with --columns; the file has: curL,b");
  expect("a,b\n1,2\n", {"a", "z"}, ":1: right current: expected a column named \"z\"; the file has: a,b");
  expect("curL,curR\n", {}, ":2: expected at least one row of numbers");
  expect("", {}, ":1: left current: expected a column for it; name it with --columns; the file has: ");
}

}  // namespace
}  // namespace hindsight::tools
