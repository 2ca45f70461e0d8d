// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/drive_command_codec.h"

#include <cmath>

#include "expect_fatal.h"

namespace hindsight {
namespace {

class DriveCommands : public testing::Test {
 protected:
  const Dbc dbc_ = read_dbc(HINDSIGHT_SOURCE_DIR "/config/lagr.dbc");
  const DriveCommandCodec codec_{dbc_, {}};
  WheelSetpoints got_;
  std::uint32_t counter_ = 0;
};

TEST_F(DriveCommands, GoThereAndBack) {
  const CanFrame frame = codec_.encode({.left_mps = 1.25, .right_mps = -0.5, .enable = true}, 21);
  EXPECT_EQ(frame.id, 128U);
  EXPECT_EQ(frame.length, 6);
  ASSERT_TRUE(codec_.decode(frame, got_, counter_));
  EXPECT_DOUBLE_EQ(got_.left_mps, 1.25);
  EXPECT_DOUBLE_EQ(got_.right_mps, -0.5);
  EXPECT_TRUE(got_.enable);
  EXPECT_EQ(counter_, 5U);
}

TEST_F(DriveCommands, AreHeldToTheSignalsLimits) {
  ASSERT_TRUE(codec_.decode(codec_.encode({.left_mps = 99.0, .right_mps = -99.0, .enable = true}, 0), got_,
                            counter_));
  EXPECT_DOUBLE_EQ(got_.left_mps, 5.0);
  EXPECT_DOUBLE_EQ(got_.right_mps, -5.0);
}

TEST_F(DriveCommands, ThatAreNotFiniteStop) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    ASSERT_TRUE(
        codec_.decode(codec_.encode({.left_mps = bad, .right_mps = 1.0, .enable = true}, 0), got_, counter_));
    EXPECT_EQ(got_.left_mps, 0.0);
    EXPECT_EQ(got_.right_mps, 0.0);
    EXPECT_FALSE(got_.enable);
  }
}

TEST_F(DriveCommands, WithAFlippedBitAreRefused) {
  const CanFrame frame = codec_.encode({.left_mps = 1.25, .right_mps = -0.5, .enable = true}, 9);
  for (int bit = 0; bit < frame.length * 8; ++bit) {
    CanFrame flipped = frame;
    flipped.data[static_cast<std::size_t>(bit / 8)] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_FALSE(codec_.decode(flipped, got_, counter_)) << bit;
  }
}

TEST_F(DriveCommands, MayLackTheEnableSignal) {
  const DriveCommandCodec codec(dbc_, {.command_enable = ""});
  ASSERT_TRUE(codec.decode(codec.encode({.left_mps = 1.0}, 0), got_, counter_));
  EXPECT_TRUE(got_.enable) << "a vehicle without the signal is always enabled";
}

TEST_F(DriveCommands, MustBeInOneMessage) {
  expect_fatal(kExitConfiguration, {"lagr.dbc", "DRIVE_COMMAND", "WHEEL_ENCODERS"},
               [&] { DriveCommandCodec(dbc_, {.command_right_speed = "WHEEL_ENCODERS.RIGHT_SPEED"}); });
  expect_fatal(kExitConfiguration, {"lagr.dbc", "command_right_speed", "DRIVE_COMMAND.RIGHT"},
               [&] { DriveCommandCodec(dbc_, {.command_right_speed = "DRIVE_COMMAND.RIGHT"}); });
}

}  // namespace
}  // namespace hindsight
