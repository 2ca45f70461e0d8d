// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/eval_road_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "config/exit_code.h"
#include "tools/road_frames.h"
#include "tools/road_labels.h"
#include "tools/road_truth.h"

namespace hindsight::tools {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const cv::Size kSize(160, 120);

class EvalRoad : public testing::Test {
 protected:
  void SetUp() override {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::path(testing::TempDir()) / ("hindsight_eval_road_" + name);
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "frames");
    fs::create_directories(folder_ / "truth");
  }

  fs::path frames() const { return folder_ / "frames"; }
  fs::path truth() const { return folder_ / "truth"; }

  /// A road of soil between gravel, straight ahead or `aside_px` to the right of it.
  cv::Mat mask(int aside_px = 0) const {
    cv::Mat road = cv::Mat::zeros(kSize, CV_8U);
    const std::vector<cv::Point> polygon{
        {79 + aside_px, 45}, {81 + aside_px, 45}, {135 + aside_px, 119}, {25 + aside_px, 119}};
    cv::fillPoly(road, std::vector{polygon}, 255);
    return road;
  }
  cv::Mat picture(int number, int aside_px = 0) const {
    cv::RNG random(static_cast<std::uint64_t>(number + 1));
    cv::Mat bgr(kSize, CV_8UC3, cv::Scalar(110, 118, 120));
    bgr.rowRange(0, 40).setTo(cv::Scalar(230, 200, 180));
    bgr.setTo(cv::Scalar(70, 105, 140), mask(aside_px));
    cv::Mat noise(kSize, CV_8UC3);
    random.fill(noise, cv::RNG::UNIFORM, 0, 12);
    return bgr + noise;
  }
  void write_frames(int count, int aside_px = 0) const {
    for (int i = 0; i < count; ++i)
      cv::imwrite((frames() / ("f" + std::to_string(i) + ".png")).string(), picture(i, aside_px));
  }
  void write_truth(int count, const std::string& suffix, int aside_px = 0) const {
    for (int i = 0; i < count; ++i)
      cv::imwrite((truth() / ("f" + std::to_string(i) + suffix + ".png")).string(), mask(aside_px));
  }

  std::string arguments(const std::string& more) const {
    return "road --frames " + frames().string() + " --truth " + truth().string() + " --rate 1 --json " + more;
  }
  nlohmann::json eval(const std::string& more = "") const {
    CLI::App app;
    tools::Run run;
    add_eval_road(app, run);
    app.parse(arguments(more));
    testing::internal::CaptureStdout();
    const int code = run();
    const std::string out = testing::internal::GetCapturedStdout();
    EXPECT_EQ(code, kExitOk);
    return nlohmann::json::parse(out);
  }
  void expect_error(ExitCode code, const std::string& text, const std::string& more = "") const {
    CLI::App app;
    tools::Run run;
    add_eval_road(app, run);
    app.parse(arguments(more));
    try {
      run();
      FAIL() << "no error; expected: " << text;
    } catch (const FatalError& error) {
      EXPECT_EQ(error.code(), code);
      EXPECT_THAT(error.what(), HasSubstr(text));
    }
  }

  fs::path folder_;
};

TEST_F(EvalRoad, TellsTheFiguresOfEachMethod) {
  write_frames(12);
  write_truth(12, "");
  for (const std::string method : {"ours", "thesis", "mrf", "hsv", "texture", "constant"}) {
    const nlohmann::json result = eval("--method " + method);
    EXPECT_EQ(result.size(), 5U) << method;
    EXPECT_EQ(result["line_coverage"].size(), 5U) << method;
    EXPECT_EQ(result["frames"], 5) << method;  // after 7 s of history
    EXPECT_TRUE(result["pixel_coverage"].is_number() && result["mttf_frames"].is_number() &&
                result["ms_per_frame"].is_number())
        << method;
  }
  EXPECT_EQ(eval("--method constant")["pixel_coverage"], 1.0);
  EXPECT_GT(eval()["pixel_coverage"], 0.8);
}

TEST_F(EvalRoad, FindsTruthByNameSuffixAndFolder) {
  write_frames(12);
  write_truth(9, "_L");
  EXPECT_EQ(eval("--method constant")["frames"], 2);
  fs::create_directories(truth() / "f11");
  cv::imwrite((truth() / "f11" / "labels.png").string(), mask());
  EXPECT_EQ(eval("--method constant")["frames"], 3);
}

TEST_F(EvalRoad, TakesAFolderForEachFrame) {
  for (int i = 0; i < 9; ++i) {
    fs::create_directories(frames() / std::to_string(i));
    cv::imwrite((frames() / std::to_string(i) / "rgb.jpg").string(), picture(i));
    cv::imwrite((frames() / std::to_string(i) / "labels.png").string(), mask());
  }
  fs::remove_all(truth());
  fs::create_symlink(frames(), truth());
  EXPECT_EQ(eval("--method constant")["frames"], 2);
}

TEST_F(EvalRoad, TakesPolygons) {
  write_frames(9);
  std::ofstream(truth() / "polygons.json")
      << R"({"width": 320, "height": 240, "polygons": {"f8": [[158, 90], [162, 90], [270, 238], [50, 238]]}})";
  EXPECT_GT(eval()["pixel_coverage"], 0.8);
}

TEST_F(EvalRoad, NumbersInNamesCountAsNumbers) {
  write_frames(12);
  const auto found = find_road_frames(frames());
  EXPECT_EQ(found[2].name, "f2");
  EXPECT_EQ(found[11].name, "f11");
}

TEST_F(EvalRoad, SaysThatHistoryIsShort) {
  write_frames(7);
  write_truth(7, "");
  expect_error(kExitBadData, "needs 7 s of history");
}

TEST_F(EvalRoad, SaysThatNoTruthIsLateEnough) {
  write_frames(12);
  write_truth(5, "");
  expect_error(kExitBadData, "no truth after the first 7 s");
}

TEST_F(EvalRoad, SaysThatThereIsNoTruth) {
  write_frames(9);
  cv::imwrite((truth() / "other.png").string(), mask());
  expect_error(kExitNoInput, "no truth for any of the 9 frames");
}

TEST_F(EvalRoad, SaysThatThereAreNoFrames) {
  write_truth(9, "");
  expect_error(kExitNoInput, "holds no frames");
}

TEST_F(EvalRoad, NamesAFrameOfAnotherSize) {
  write_frames(9);
  write_truth(9, "");
  cv::imwrite((frames() / "f5.png").string(), cv::Mat(60, 80, CV_8UC3, cv::Scalar::all(9)));
  expect_error(kExitBadData, "f5.png: is 80 x 60 pixels; expected 160 x 120");
}

TEST_F(EvalRoad, SaysThatTheDefinitionRegionIsOffTheRoad) {
  write_frames(9, 120);
  write_truth(9, "", 120);
  expect_error(kExitBadData, "is off the road in all of the 2 scored frames");
}

TEST_F(EvalRoad, NamesLabelsWithoutATable) {
  write_frames(9);
  for (int i = 0; i < 9; ++i)
    cv::imwrite((truth() / ("f" + std::to_string(i) + ".png")).string(),
                cv::Mat(kSize, CV_8UC3, cv::Scalar(1, 2, 3)));
  expect_error(kExitBadData, "no built-in table knows its colours");
  std::ofstream(truth() / "labels.toml") << "[labels]\nroad = [\"#030201\"]\n";
  EXPECT_EQ(eval("--method constant")["pixel_coverage"], 1.0);
  std::ofstream(truth() / "labels.toml") << "[labels]\nroad = [\"brown\"]\n";
  expect_error(kExitConfiguration, "\"brown\" is not a colour");
}

TEST(RoadLabels, BuiltInTablesKnowRealLabelImages) {
  const char* data = std::getenv("HINDSIGHT_DATA");
  if (data == nullptr) GTEST_SKIP() << "no data";
  const fs::path run = fs::path(data) / "trail_ycor_run";
  const auto frames = find_road_frames(run);
  EXPECT_EQ(frames.size(), 46U);
  const RoadTruth truth(run, frames, "");
  EXPECT_EQ(truth.size(), 46U);
  EXPECT_GT(cv::countNonZero(truth.mask("1260", {1024, 544}) == 1), 20000);
}

TEST(RoadTruth, HandOutlinedFramesAreAllThere) {
  const char* data = std::getenv("HINDSIGHT_DATA");
  if (data == nullptr) GTEST_SKIP() << "no data";
  const auto frames = find_road_frames(fs::path(data) / "road_kitti0019");
  const RoadTruth truth(fs::path(HINDSIGHT_SOURCE_DIR) / "tests/data/road_kitti0019", frames, "");
  EXPECT_EQ(truth.size(), 30U);
  EXPECT_GT(cv::countNonZero(truth.mask("000100", {1242, 375})), 40000);
}

}  // namespace
}  // namespace hindsight::tools
