// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <linux/can.h>
#include <linux/can/error.h>

#include "drivers/can_sender.h"
#include "drivers/socketcan_bus.h"
#include "expect_fatal.h"
#include "on_device.h"

namespace hindsight {
namespace {

class Vcan : public OnDevice {
 protected:
  void SetUp() override {
    OnDevice::SetUp();
    if (IsSkipped()) return;
    run("ip link del vcan7 2> /dev/null");
    ASSERT_TRUE(run("ip link add vcan7 type vcan && ip link set vcan7 up"));
  }
  void TearDown() override {
    if (!IsSkipped()) run("ip link del vcan7 2> /dev/null");
  }
  static CanBusParams params() {
    CanBusParams result;
    result.interface = "vcan7";
    return result;
  }
  static CanFrame frame(std::uint32_t id, std::uint8_t first = 0) {
    return {.id = id, .length = 8, .data = {first}};
  }
};

TEST_F(Vcan, CarriesFramesWithTheirTimes) {
  SocketCanBus bus(params(), {0x100, 0x101}, sink_);
  CanSender sender("vcan7", {});
  const Time before = monotonic_now();
  for (std::uint8_t i = 0; i < 100; ++i) EXPECT_EQ(sender.send(frame(0x100 + i % 2U, i), before), 0);
  ASSERT_TRUE(serve(bus, [&] { return sink_.can.size() >= 100; }));
  for (std::size_t i = 0; i < 100; ++i) {
    EXPECT_EQ(sink_.can[i].id, 0x100 + i % 2);
    EXPECT_EQ(sink_.can[i].data[0], i);
    EXPECT_EQ(sink_.can[i].length, 8);
    EXPECT_GE(sink_.can[i].stamp, before - milliseconds(1));
    EXPECT_LE(sink_.can[i].stamp, monotonic_now());
  }
  EXPECT_TRUE(sink_.last_state_is(SourceState::fresh));
}

TEST_F(Vcan, StampsSayWhenAFrameCameNotWhenItWasRead) {
  SocketCanBus bus(params(), {0x100}, sink_);
  CanSender sender("vcan7", {});
  sender.send(frame(0x100), monotonic_now());
  const Time sent = monotonic_now();
  std::this_thread::sleep_for(milliseconds(200));
  ASSERT_TRUE(serve(bus, [&] { return !sink_.can.empty(); }));
  EXPECT_LT(sink_.can[0].stamp, sent + milliseconds(50));
}

TEST_F(Vcan, OnlyTheWantedIdentifiersAndErrorFramesComeIn) {
  SocketCanBus bus(params(), {0x100, 0x105 | CAN_EFF_FLAG}, sink_);
  CanSender sender("vcan7", {});
  for (const std::uint32_t id : {0x0FFU, 0x101U, 0x105U, 0x100U | CAN_EFF_FLAG, 0x100U | CAN_RTR_FLAG}) {
    sender.send(frame(id), {});
  }
  sender.send(frame(CAN_ERR_FLAG | CAN_ERR_BUSOFF), {});
  sender.send(frame(0x105 | CAN_EFF_FLAG), {});
  ASSERT_TRUE(serve(bus, [&] { return sink_.can.size() >= 2; }));
  EXPECT_EQ(sink_.can.size(), 2U);
  EXPECT_EQ(sink_.can[0].id, CAN_ERR_FLAG | CAN_ERR_BUSOFF);
  EXPECT_EQ(sink_.can[1].id, 0x105 | CAN_EFF_FLAG);
}

TEST_F(Vcan, AFloodIsBoundedAndItsLossesAreCounted) {
  SocketCanBus bus(params(), {0x100}, sink_);
  CanSender sender("vcan7", {});
  for (int i = 0; i < 5000; ++i) sender.send(frame(0x100), {});
  bus.service(milliseconds(20));
  EXPECT_LE(sink_.can.size(), 256U + 32U);
  serve(
      bus, [] { return false; }, milliseconds(200));
  sender.send(frame(0x100), {});  // losses are told with the next frame
  ASSERT_TRUE(serve(bus, [&] { return !sink_.reports.empty() && sink_.reports.back().dropped > 0; }));
  EXPECT_EQ(sink_.can.size() + sink_.reports.back().dropped, 5001U);
}

TEST_F(Vcan, ComesBackAfterTheLinkWasDown) {
  SocketCanBus bus(params(), {0x100}, sink_);
  CanSender sender("vcan7", {});
  ASSERT_TRUE(run("ip link set vcan7 down"));
  ASSERT_TRUE(serve(bus, [&] { return sink_.last_state_is(SourceState::failed); }));
  EXPECT_EQ(sink_.reports.back().error_code, ENETDOWN);
  EXPECT_EQ(sender.send(frame(0x100), monotonic_now()), ENETDOWN);
  ASSERT_TRUE(run("ip link set vcan7 up"));
  EXPECT_TRUE(serve(bus, [&] {
    sender.send(frame(0x100), monotonic_now());
    return sink_.last_state_is(SourceState::fresh);
  }));
}

TEST_F(Vcan, ComesBackAfterTheInterfaceWasGone) {
  SocketCanBus bus(params(), {0x100}, sink_);
  CanSender sender("vcan7", {});
  ASSERT_TRUE(run("ip link del vcan7"));
  ASSERT_TRUE(serve(bus, [&] { return sink_.last_state_is(SourceState::failed); }));
  EXPECT_NE(sender.send(frame(0x100), monotonic_now()), 0);
  ASSERT_TRUE(run("ip link add vcan7 type vcan && ip link set vcan7 up"));
  EXPECT_TRUE(serve(bus, [&] {
    sender.send(frame(0x100), monotonic_now());
    return sink_.last_state_is(SourceState::fresh);
  }));
}

TEST_F(Vcan, ALinkThatIsDownAtStartIsRefused) {
  ASSERT_TRUE(run("ip link set vcan7 down"));
  expect_fatal(kExitNoDevice, {"vcan7", "down"}, [&] { SocketCanBus(params(), {0x100}, sink_); });
  expect_fatal(kExitNoDevice, {"vcan7", "down"}, [&] { CanSender("vcan7", {}); });
}

}  // namespace
}  // namespace hindsight
