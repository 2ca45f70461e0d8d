// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/saved_state.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "daemon/driven_track.h"
#include "daemon/model_store.h"
#include "daemon/run_setup.h"

namespace hindsight {
namespace {

namespace fs = std::filesystem;

SavedState some_state() {
  return {1'700'000'000'000'000, -0.0123, {{0.0, 0.0, 0.0}, {1.5, -2.0, 0.5}, {3.0, 1e6, -3.0}}};
}

TEST(SavedState, GivesBackWhatItWasGiven) {
  const SavedState state = some_state();
  const StateDecoded decoded = decode_state(encode_state(state));
  ASSERT_EQ(decoded.problem, "");
  EXPECT_EQ(decoded.state.utime_us, state.utime_us);
  EXPECT_EQ(decoded.state.gyro_bias_radps, state.gyro_bias_radps);
  ASSERT_EQ(decoded.state.track.size(), state.track.size());
  for (std::size_t i = 0; i < state.track.size(); ++i) {
    EXPECT_EQ(decoded.state.track[i].x_m, state.track[i].x_m);
    EXPECT_EQ(decoded.state.track[i].y_m, state.track[i].y_m);
    EXPECT_EQ(decoded.state.track[i].heading_rad, state.track[i].heading_rad);
  }
}

TEST(SavedState, EveryCutAndEveryFlippedBitIsRefused) {
  const std::vector<std::uint8_t> whole = encode_state(some_state());
  for (std::size_t cut = 0; cut < whole.size(); ++cut) {
    EXPECT_NE(decode_state(std::span(whole).first(cut)).problem, "") << cut;
  }
  for (std::size_t bit = 0; bit < whole.size() * 8; ++bit) {
    std::vector<std::uint8_t> damaged = whole;
    damaged[bit / 8] = static_cast<std::uint8_t>(damaged[bit / 8] ^ (1U << (bit % 8)));
    EXPECT_NE(decode_state(damaged).problem, "") << bit;
  }
}

TEST(SavedState, NumbersThatMeanNothingAreRefused) {
  for (const double bias_radps : {std::numeric_limits<double>::quiet_NaN(), 1.5, -2.0}) {
    EXPECT_EQ(decode_state(encode_state({0, bias_radps, {}})).problem, "its gyro bias is none");
  }
  EXPECT_EQ(decode_state(encode_state({0, 0.0, {{INFINITY, 0.0, 0.0}}})).problem, "a pose is none");
}

/// A run begins with the last one's bias, its log says so, and what reads the log begins with the same bits.
TEST(SavedState, ItsBiasReachesTheRunAndItsLog) {
  const fs::path file = fs::path(testing::TempDir()) / ("hindsight_saved_state_" + std::to_string(getpid()));
  Configuration configuration;
  configuration.robot.state_file = file.string();
  EXPECT_EQ(with_saved_state(configuration).localisation.initial_gyro_bias_radps, 0.0) << "nothing saved yet";
  const double bias_radps = 0.1 / 3.0;
  ASSERT_EQ(save_atomically(file, encode_state({1, bias_radps, {}})), "");
  const Configuration begun = with_saved_state(configuration);
  EXPECT_EQ(begun.localisation.initial_gyro_bias_radps, bias_radps);
  RunHeader header;
  header.configuration = to_text(begun);
  EXPECT_EQ(configuration_of(header).localisation.initial_gyro_bias_radps, bias_radps);
  for (const fs::path& copy : saved_copies_of(file)) fs::remove(copy);
}

TEST(DrivenTrack, KeepsTheLastPosesThatAreApart) {
  DrivenTrack track;
  EXPECT_TRUE(track.poses().empty());
  constexpr int kSteps = 3000;
  for (int i = 0; i < kSteps; ++i) track.add({0.1 * i, 0.0, 0.0});
  const std::vector<Pose2> poses = track.poses();
  ASSERT_EQ(poses.size(), DrivenTrack::kMostPoses);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    EXPECT_GE(poses[i].x_m - poses[i - 1].x_m, DrivenTrack::kSpacing_m);
    EXPECT_LT(poses[i].x_m - poses[i - 1].x_m, DrivenTrack::kSpacing_m + 0.1 + 1e-9);
  }
  EXPECT_GT(poses.back().x_m, 0.1 * (kSteps - 1) - DrivenTrack::kSpacing_m - 0.1);
}

}  // namespace
}  // namespace hindsight
