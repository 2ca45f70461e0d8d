// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/vehicle_decoder.h"

#include <linux/can.h>
#include <linux/can/error.h>

#include <set>

#include "drivers/vehicle_base_codec.h"
#include "expect_fatal.h"

namespace hindsight {
namespace {

constexpr Time kStamp = std::chrono::milliseconds(1234);

class VehicleDecoding : public testing::Test {
 protected:
  CanFrame sample(SignalGroup group) {
    std::vector<CanFrame> frames;
    base_.encode(group, sent_, kStamp, frames);
    EXPECT_EQ(frames.size(), 1U);
    return frames.at(0);
  }

  const Dbc dbc_ = read_dbc(HINDSIGHT_SOURCE_DIR "/config/lagr.dbc");
  VehicleBaseCodec base_{dbc_, {}};
  VehicleDecoder decoder_{dbc_, {}};
  VehicleSignals sent_{.left_mps = 0.7,
                       .right_mps = -0.3,
                       .left_ticks = 17,
                       .right_ticks = 4095,
                       .left_a = 3.25,
                       .right_a = -1.5,
                       .ir_left_m = 0.8,
                       .ir_right_m = 4.0,
                       .battery_v = 25.6,
                       .yaw_rate_radps = -0.5};
};

TEST_F(VehicleDecoding, EachGroupArrivesWithItsTime) {
  for (int i = 0; i < kSignalGroupCount; ++i) {
    const auto group = static_cast<SignalGroup>(i);
    EXPECT_TRUE(decoder_.mapped().has(group));
    EXPECT_TRUE(decoder_.decode(sample(group)).has(group));
    // Wheels and ticks share their message, so the second of them comes with the next counter.
  }
  const VehicleSignals& got = decoder_.signals();
  EXPECT_NEAR(got.left_mps, 0.7, 1e-9);
  EXPECT_NEAR(got.right_mps, -0.3, 1e-9);
  EXPECT_EQ(got.left_ticks, 17);
  EXPECT_EQ(got.right_ticks, 4095);
  EXPECT_NEAR(got.left_a, 3.25, 1e-9);
  EXPECT_NEAR(got.right_a, -1.5, 1e-9);
  EXPECT_NEAR(got.ir_left_m, 0.8, 1e-9);
  EXPECT_NEAR(got.ir_right_m, 4.0, 1e-9);
  EXPECT_NEAR(got.battery_v, 25.6, 1e-9);
  EXPECT_NEAR(got.yaw_rate_radps, -0.5, 1e-9);
  for (const Time stamp : {got.wheels_stamp, got.ticks_stamp, got.currents_stamp, got.ir_stamp,
                           got.battery_stamp, got.imu_stamp}) {
    EXPECT_EQ(stamp, kStamp);
  }
  EXPECT_EQ(got.bus.good_frames, 6U);
}

TEST_F(VehicleDecoding, ReceivesItsMessagesOnly) {
  const std::vector<std::uint32_t> ids = decoder_.received_ids();
  EXPECT_EQ(std::set<std::uint32_t>(ids.begin(), ids.end()),
            (std::set<std::uint32_t>{256, 257, 258, 259, 260}));
  CanFrame other{.id = 0x123, .length = 8};
  EXPECT_TRUE(decoder_.decode(other).empty());
  CanFrame remote = sample(SignalGroup::battery);
  remote.id |= CAN_RTR_FLAG;
  EXPECT_TRUE(decoder_.decode(remote).empty());
  EXPECT_EQ(decoder_.signals().bus.good_frames, 0U);
}

TEST_F(VehicleDecoding, EveryFlippedBitOfIdentifierOrDataChangesNothing) {
  for (int i = 0; i < kSignalGroupCount; ++i) {
    const CanFrame frame = sample(static_cast<SignalGroup>(i));
    for (int bit = 0; bit < 29 + frame.length * 8; ++bit) {
      CanFrame flipped = frame;
      if (bit < 29)
        flipped.id ^= 1U << bit;
      else
        flipped.data[static_cast<std::size_t>((bit - 29) / 8)] ^=
            static_cast<std::uint8_t>(1U << ((bit - 29) % 8));
      EXPECT_TRUE(decoder_.decode(flipped).empty()) << "group " << i << " bit " << bit;
    }
  }
  EXPECT_EQ(decoder_.signals().bus.good_frames, 0U);
  EXPECT_EQ(decoder_.signals().wheels_stamp, Time{});
}

TEST_F(VehicleDecoding, RepeatedAndSkippedCountersAreDropped) {
  EXPECT_FALSE(decoder_.decode(sample(SignalGroup::battery)).empty());
  const CanFrame second = sample(SignalGroup::battery);
  EXPECT_FALSE(decoder_.decode(second).empty());
  EXPECT_TRUE(decoder_.decode(second).empty()) << "repeated";
  sample(SignalGroup::battery);  // lost on the way
  EXPECT_TRUE(decoder_.decode(sample(SignalGroup::battery)).empty()) << "skipped";
  EXPECT_EQ(decoder_.signals().bus.bad_counters, 2U);
  EXPECT_EQ(decoder_.signals().bus.consecutive_bad, 2U);
  EXPECT_FALSE(decoder_.decode(sample(SignalGroup::battery)).empty()) << "in step again";
  EXPECT_EQ(decoder_.signals().bus.consecutive_bad, 0U);
  EXPECT_EQ(decoder_.signals().bus.good_frames, 3U);
}

TEST_F(VehicleDecoding, CounterGoesRoundAndRound) {
  for (int i = 0; i < 40; ++i) EXPECT_FALSE(decoder_.decode(sample(SignalGroup::imu)).empty()) << i;
}

TEST_F(VehicleDecoding, CountsByMessage) {
  CanFrame frame = sample(SignalGroup::ir_ranges);
  frame.data[0] ^= 1U;
  decoder_.decode(frame);
  for (const MessageCounts& counts : decoder_.messages()) {
    EXPECT_EQ(counts.bad_checksum, counts.name == "IR_RANGES" ? 1U : 0U) << counts.name;
  }
}

TEST_F(VehicleDecoding, ValuesOutsideTheDeclaredLimitsAreDropped) {
  const DbcMessage& declared = *dbc_.find("WHEEL_ENCODERS");
  CanFrame frame = sample(SignalGroup::wheels);
  insert_bits(frame.data, *declared.find("LEFT_SPEED"), 6000);  // 6 m/s
  ProtectedMessage(dbc_, declared, "COUNTER", "CHECKSUM").seal(frame, 1);
  EXPECT_TRUE(decoder_.decode(frame).empty());
  EXPECT_EQ(decoder_.signals().bus.bad_values, 1U);
  EXPECT_EQ(decoder_.signals().left_mps, 0.0);
}

TEST_F(VehicleDecoding, BusOffIsSeenUntilTheRestart) {
  CanFrame error{.id = CAN_ERR_FLAG | CAN_ERR_BUSOFF, .length = 8};
  EXPECT_TRUE(decoder_.decode(error).empty());
  EXPECT_TRUE(decoder_.signals().bus.bus_off);
  error.id = CAN_ERR_FLAG | CAN_ERR_CRTL;
  error.data[6] = 96;
  error.data[7] = 3;
  decoder_.decode(error);
  EXPECT_TRUE(decoder_.signals().bus.bus_off);
  EXPECT_EQ(decoder_.signals().bus.transmit_errors, 96);
  EXPECT_EQ(decoder_.signals().bus.receive_errors, 3);
  error.id = CAN_ERR_FLAG | CAN_ERR_RESTARTED;
  decoder_.decode(error);
  EXPECT_FALSE(decoder_.signals().bus.bus_off);
  EXPECT_EQ(decoder_.signals().bus.bus_offs, 1U);
  EXPECT_EQ(decoder_.signals().bus.error_frames, 3U);
}

TEST(VehicleMapping, APairMayComeInTwoMessages) {
  const std::string protection =
      " SG_ COUNTER : 16|4@1+ (1,0) [0|0] \"\" B\n SG_ CHECKSUM : 24|8@1+ (1,0) [0|0] \"\" B\n";
  const Dbc dbc =
      parse_dbc("BO_ 1 LEFT: 4 A\n SG_ SPEED : 7|16@0- (0.01,0) [0|0] \"m/s\" B\n" + protection +
                    "BO_ 2 RIGHT: 4 A\n SG_ SPEED : 7|16@0- (0.01,0) [0|0] \"m/s\" B\n" + protection,
                "two.dbc");
  const CanRolesParams roles{.left_speed = "LEFT.SPEED",
                             .right_speed = "RIGHT.SPEED",
                             .left_ticks = "",
                             .right_ticks = "",
                             .left_current = "",
                             .right_current = "",
                             .left_range = "",
                             .right_range = "",
                             .battery_voltage = "",
                             .yaw_rate = ""};
  VehicleDecoder decoder(dbc, roles);
  VehicleBaseCodec base(dbc, roles);
  std::vector<CanFrame> frames;
  VehicleSignals sent;
  sent.left_mps = 0.5;
  sent.right_mps = -0.25;
  base.encode(SignalGroup::wheels, sent, kStamp, frames);
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_TRUE(decoder.decode(frames[0]).empty());
  EXPECT_TRUE(decoder.decode(frames[1]).has(SignalGroup::wheels));
  EXPECT_DOUBLE_EQ(decoder.signals().left_mps, 0.5);
  EXPECT_DOUBLE_EQ(decoder.signals().right_mps, -0.25);
  EXPECT_FALSE(decoder.mapped().has(SignalGroup::imu));
  frames.clear();
  base.encode(SignalGroup::imu, sent, kStamp, frames);
  EXPECT_TRUE(frames.empty());
}

TEST(VehicleMapping, ErrorsNameRoleSignalAndFile) {
  const Dbc dbc = read_dbc(HINDSIGHT_SOURCE_DIR "/config/lagr.dbc");
  const auto refused = [&](auto change, const std::vector<std::string>& parts) {
    CanRolesParams roles;
    change(roles);
    expect_fatal(kExitConfiguration, parts, [&] { VehicleDecoder(dbc, roles); });
  };
  refused([](auto& r) { r.left_speed = "WHEEL_ENCODERS.SPEED_LEFT"; },
          {"lagr.dbc", "left_speed", "WHEEL_ENCODERS.SPEED_LEFT", "no signal SPEED_LEFT"});
  refused([](auto& r) { r.yaw_rate = "GYRO.YAW_RATE"; },
          {"lagr.dbc", "yaw_rate", "GYRO.YAW_RATE", "no message GYRO"});
  refused([](auto& r) { r.yaw_rate = "YAW_RATE"; }, {"yaw_rate", "MESSAGE.SIGNAL"});
  refused([](auto& r) { r.left_speed = r.right_speed = ""; }, {"left_speed", "MESSAGE.SIGNAL"});
  refused([](auto& r) { r.left_current = ""; }, {"left_current", "right_current", "both or neither"});
  refused([](auto& r) { r.right_speed = r.left_speed; }, {"right_speed", "another role"});
  refused([](auto& r) { r.yaw_rate = "IMU.FORWARD_ACCELERATION"; }, {"yaw_rate", "rad/s", "m/s^2"});
  refused([](auto& r) { r.counter = "ALIVE"; }, {"WHEEL_ENCODERS", "counter", "ALIVE"});
}

TEST(VehicleMapping, MultiplexedSignalsAreRefused) {
  const Dbc dbc = parse_dbc(
      "BO_ 1 MSG: 8 A\n SG_ SWITCH M : 0|8@1+ (1,0) [0|0] \"\" B\n SG_ SPEED m0 : 8|8@1+ (1,0) [0|0] \"m/s\" "
      "B\n",
      "mux.dbc");
  CanRolesParams roles;
  roles.left_speed = "MSG.SPEED";
  expect_fatal(kExitConfiguration, {"mux.dbc", "left_speed", "MSG.SPEED", "multiplexed"},
               [&] { VehicleDecoder(dbc, roles); });
}

}  // namespace
}  // namespace hindsight
