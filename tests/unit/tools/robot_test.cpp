// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The whole core on a made drive: tools/bench_drive.h gives it frames, wheels and currents.
#include "daemon/robot.h"

#include <gtest/gtest.h>

#include <functional>
#include <hindsight/training_t.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "perception/mixture_codec.h"
#include "tools/allocation_counter.h"
#include "tools/bench_drive.h"
#include "tools/builtin_config.h"

namespace hindsight::tools {
namespace {

/// Coloured noise that grows from frame to frame, as if one drove towards a wall of leaves.
std::vector<cv::Mat> growing_noise(int count) {
  cv::RNG random(3);
  cv::Mat coarse(80, 120, CV_8UC3);
  random.fill(coarse, cv::RNG::UNIFORM, 0, 256);
  cv::Mat texture;
  cv::resize(coarse, texture, cv::Size(1200, 800), 0.0, 0.0, cv::INTER_CUBIC);
  std::vector<cv::Mat> frames;
  for (int i = 0; i < count; ++i) {
    const double zoom = 0.8 * std::pow(1.01, i);
    const cv::Matx23d warp(zoom, 0.0, 360.0 - zoom * 600.0, 0.0, zoom, 240.0 - zoom * 400.0);
    cv::Mat frame;
    cv::warpAffine(texture, frame, warp, cv::Size(720, 480), cv::INTER_LINEAR, cv::BORDER_REFLECT);
    frames.push_back(frame);
  }
  return frames;
}

class RobotDrive : public testing::Test {
 protected:
  explicit RobotDrive(const Configuration& configuration = {})
      : drive_(growing_noise(24)), robot_(BenchDrive::setup(configuration)) {
    input_.reserve();
  }

  Decision step(const std::function<void(TickInput&)>& change = {}) {
    drive_.fill(tick_++, input_);
    if (change) change(input_);
    outbox_.clear();
    return robot_.step(input_, outbox_);
  }

  template <typename Message>
  std::vector<Message> published(std::string_view channel) const {
    std::vector<Message> found;
    for (const Outbox::Message& message : outbox_.messages()) {
      if (message.channel != channel) continue;
      Message decoded;
      EXPECT_GT(decoded.decode(message.bytes.data(), 0, static_cast<int>(message.bytes.size())), 0);
      found.push_back(decoded);
    }
    return found;
  }

  BenchDrive drive_;
  Robot robot_;
  TickInput input_;
  Outbox outbox_;
  std::uint64_t tick_ = 0;
};

TEST_F(RobotDrive, StandsUntilArmedAndThenDrives) {
  EXPECT_EQ(step().reason, StopReason::not_armed);
  for (int i = 0; i < 10; ++i) step();
  const Decision decision = step();
  EXPECT_EQ(decision.reason, StopReason::none);
  EXPECT_GT(decision.command.left_mps + decision.command.right_mps, 0.0);
}

TEST_F(RobotDrive, StopsWhenTheCameraIsSilent) {
  for (int i = 0; i < 10; ++i) step();
  Decision decision;
  for (int i = 0; i < 4; ++i) decision = step([](TickInput& input) { input.frame = {}; });
  EXPECT_EQ(decision.reason, StopReason::camera);
  EXPECT_EQ(decision.command, DriveCommand{});
  EXPECT_EQ(step().reason, StopReason::camera) << "latched until an operator arms";
}

TEST_F(RobotDrive, IgnoresAFrameOfAnotherSize) {
  for (int i = 0; i < 5; ++i) step();
  const int before = robot_.sight().appearance().size();
  FramePool pool(1, 0, 0);
  step([&](TickInput& input) {
    FrameRef taken = pool.take();
    if (!taken) return;
    Frame& small = taken.writable();
    small.width_px = 64;
    small.height_px = 48;
    small.bgr.assign(64 * 48 * 3, 0);
    small.stamp = input.now;
    input.frame = taken;
  });
  EXPECT_EQ(robot_.sight().appearance().size(), before);
  input_.clear();  // the frame goes back before its pool ends
}

TEST_F(RobotDrive, ATouchIsTracedBackTrainedAndMarked) {
  Configuration configuration;
  configuration.reverse_flow.looks = "far";  // these pictures slide, so that nothing gets smaller on its way back
  Robot robot(BenchDrive::setup(configuration));
  for (int i = 0; i <= 20; ++i) {
    drive_.fill(tick_++, input_);
    if (i == 20) input_.edges.push_back({input_.now, Line::bumper_left, true});
    outbox_.clear();
    robot.step(input_, outbox_);
  }
  bool found = false;
  for (const training_t& lesson : published<training_t>("HINDSIGHT_TRAINING")) {
    if (lesson.cause != static_cast<int>(TrainingCause::bumper_left)) continue;
    found = true;
    EXPECT_EQ(lesson.label, static_cast<int>(TerrainClass::lethal));
    EXPECT_TRUE(lesson.in_view);
    EXPECT_GT(lesson.to_frames_back, 2);
    EXPECT_GT(lesson.pixels, 20);
    const GridWindow& window = robot.grid().window();
    EXPECT_EQ(robot.grid().cost(window.cell_at(lesson.place_m[0], lesson.place_m[1])), CellCost::lethal);
  }
  EXPECT_TRUE(found);
}

TEST_F(RobotDrive, WithoutLearningTheMixtureStands) {
  Configuration configuration;
  configuration.robot.learning = false;
  Robot robot(BenchDrive::setup(configuration));
  for (int i = 0; i < 20; ++i) {
    drive_.fill(tick_++, input_);
    if (i == 10) input_.edges.push_back({input_.now, Line::bumper_left, true});
    outbox_.clear();
    robot.step(input_, outbox_);
    if (i == 5) tick_ = 6;
  }
  for (const MixtureComponent& component : robot.learner().mixture().components()) {
    EXPECT_EQ(component.votes, (std::array<double, kLabelCount>{}));
  }
}

TEST_F(RobotDrive, TheSameInputsGiveTheSameBytes) {
  Robot twin(BenchDrive::setup(Configuration{}));
  Outbox twins;
  for (int i = 0; i < 40; ++i) {
    step([i](TickInput& input) {
      if (i == 25) input.edges.push_back({input.now, Line::bumper_right, true});
      if (i == 28) input.edges.push_back({input.now, Line::bumper_right, false});
    });
    twins.clear();
    twin.step(input_, twins);
    ASSERT_EQ(outbox_.messages().size(), twins.messages().size());
    for (std::size_t m = 0; m < twins.messages().size(); ++m) {
      ASSERT_EQ(outbox_.messages()[m].channel, twins.messages()[m].channel);
      ASSERT_TRUE(std::ranges::equal(outbox_.messages()[m].bytes, twins.messages()[m].bytes))
          << twins.messages()[m].channel << ", tick " << i;
    }
  }
}

TEST_F(RobotDrive, ASavedMixtureGoesOnWhereItEnded) {
  for (int i = 0; i < 30; ++i) step();
  RobotSetup setup = BenchDrive::setup(Configuration{});
  const auto bytes = encode_mixture(robot_.learner().snapshot());
  const MixtureDecoded decoded = decode_mixture(bytes);
  ASSERT_EQ(decoded.problem, "");
  setup.mixture = decoded.mixture;
  const Robot again(setup);
  EXPECT_EQ(again.learner().mixture().components(), robot_.learner().mixture().components());
}

TEST_F(RobotDrive, SteadyTicksAllocateNothing) {
#ifdef HINDSIGHT_SANITIZED
  GTEST_SKIP() << "a sanitizer brings its own malloc";
#else
  for (int i = 0; i < 30; ++i) step();
  for (int i = 0; i < 60; ++i) {
    drive_.fill(tick_++, input_);
    outbox_.clear();
    const std::uint64_t before = allocations_of_this_thread();
    robot_.step(input_, outbox_);
    const std::uint64_t made = allocations_of_this_thread() - before;
    if (!robot_.learner().lessons().empty()) continue;
    ASSERT_EQ(made, 0U) << "in tick " << input_.index;
  }
#endif
}

TEST(ThesisConfiguration, HasTheThesisNumbers) {
  const Configuration thesis = thesis_configuration();
  EXPECT_EQ(thesis.flow.corners.max_features, 3000);
  EXPECT_EQ(thesis.flow.corners.quality, 0.05);
  EXPECT_EQ(thesis.flow.tracker.pyramid_levels, 5);
  EXPECT_EQ(thesis.flow.tracker.window_px, 3);
  EXPECT_EQ(thesis.flow_history.columns, 12);
  EXPECT_EQ(thesis.flow_history.rows, 8);
  EXPECT_EQ(thesis.flow_history.depth, 200);
  EXPECT_EQ(thesis.mixture.start_components, 16);
  EXPECT_EQ(thesis.mixture.gate, 0.9);
  EXPECT_EQ(thesis.slip.threshold, 0.25);
  EXPECT_FALSE(thesis.ground_slip.enabled);
  EXPECT_EQ(thesis.evidence_grid.resolution_m, 0.2);
}

}  // namespace
}  // namespace hindsight::tools
