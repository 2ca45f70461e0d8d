// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/traceback_evaluation.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "config/exit_code.h"
#include "perception/optical_flow.h"
#include "tools/bench_flow.h"
#include "tools/builtin_config.h"
#include "tools/opencv_flow.h"

namespace hindsight::tools {
namespace {

namespace fs = std::filesystem;

/// Views of one random picture that move by the offset given.
cv::Mat view(cv::Point2d offset, cv::Size size) {
  cv::Mat noise(512, 768, CV_8UC3), smooth, window;
  cv::RNG random(7);
  random.fill(noise, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(noise, smooth, {9, 9}, 2.0);
  cv::normalize(smooth, smooth, 0, 255, cv::NORM_MINMAX);
  const cv::Mat moved = (cv::Mat_<double>(2, 3) << 1.0, 0.0, -offset.x, 0.0, 1.0, -offset.y);
  cv::warpAffine(smooth, window, moved, size, cv::INTER_LINEAR);
  return window;
}

class TracebackEvaluation : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const std::string& name, const cv::Mat& image) { cv::imwrite((folder_ / name).string(), image); }
  fs::path folder_;
};

TEST_F(TracebackEvaluation, FindsNoErrorWhereTheSceneOnlySlides) {
  for (int i = 0; i < 14; ++i)
    write(cv::format("%03d.png", i), view({40.0 + 2.5 * i, 60.0 + 1.5 * i}, {320, 200}));
  ImageFolder frames(folder_);
  std::vector<TracebackArm> arms;
  arms.push_back(hindsight_arm("default", {}, {}, {320, 200}));
  arms.push_back(opencv_arm("thesis_opencv", thesis_configuration().flow, thesis_configuration().flow_history,
                            {320, 200}));
  int done = 0;
  evaluate_traceback(frames, arms, [&](int frame) { done = frame; });
  EXPECT_EQ(done, 14);
  const TracebackSummary summary = summarise(arms[0].errors, 10);
  EXPECT_GT(summary.tracks, 50);
  EXPECT_LT(summary.median_px, 0.5);
  EXPECT_LT(summary.p75_px, 1.0);
  EXPECT_EQ(summarise(arms[0].errors, 30).tracks, 0);
  EXPECT_EQ(summarise(arms[1].errors, 10).tracks, summary.tracks);
}

TEST_F(TracebackEvaluation, RefusesAFolderWithoutPicturesOrWithOddOnes) {
  const auto code_of = [&](auto&& work) {
    try {
      work();
    } catch (const FatalError& error) {
      EXPECT_NE(std::string(error.what()).find(folder_.string()), std::string::npos) << error.what();
      return static_cast<int>(error.code());
    }
    return 0;
  };
  EXPECT_EQ(code_of([&] { ImageFolder(folder_ / "absent"); }), kExitNoInput);
  EXPECT_EQ(code_of([&] { ImageFolder{folder_}; }), kExitNoInput);
  write("0.png", cv::Mat::zeros(20, 30, CV_8UC3));
  write("1.png", cv::Mat::zeros(20, 31, CV_8UC3));
  std::ofstream(folder_ / "2.png") << "no picture";
  ImageFolder frames(folder_);
  EXPECT_EQ(frames.size(), 3);
  EXPECT_EQ(code_of([&] { frames.read(0); }), 0);
  EXPECT_EQ(code_of([&] { frames.read(1); }), kExitBadData);
  EXPECT_EQ(code_of([&] { frames.read(2); }), kExitBadData);
}

TEST(OpencvFlow, AgreesWithOurFlow) {
  const cv::Size size(320, 200);
  const cv::Mat first = view({100.0, 100.0}, size), second = view({103.3, 98.4}, size);
  OpencvFlow theirs(thesis_configuration().flow);
  OpticalFlow ours(thesis_configuration().flow, size.width, size.height);
  EXPECT_TRUE(theirs.update(first).empty());
  EXPECT_TRUE(ours.update({first.data, first.total() * 3}).empty());
  for (const auto flow : {theirs.update(second), ours.update({second.data, second.total() * 3})}) {
    std::vector<double> errors;
    for (const FlowVector& v : flow) errors.push_back(std::hypot(v.dx_px - 3.3, v.dy_px + 1.6));
    ASSERT_GT(errors.size(), 100U);
    std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2),
                     errors.end());
    EXPECT_LT(errors[errors.size() / 2], 0.1);
  }
}

TEST(BenchFlow, TimesAllThree) {
  const std::vector<cv::Mat> frames = {view({0, 0}, {160, 120}), view({1, 1}, {160, 120}),
                                       view({2, 2}, {160, 120})};
  const FlowBench bench =
      bench_flow(frames, thesis_configuration().flow, thesis_configuration().flow_history, {}, {});
  EXPECT_GT(bench.opencv_ms, 0.0);
  EXPECT_GT(bench.thesis_ms, 0.0);
  EXPECT_GT(bench.default_ms, 0.0);
}

}  // namespace
}  // namespace hindsight::tools
