// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/sim_fault.h"

#include <gtest/gtest.h>

#include "sim_replay/vehicle/sim_vehicle.h"
#include "tools/builtin_config.h"
#include "tools/stop_watch.h"

namespace hindsight::tools {
namespace {

World flat_world() {
  World world;
  world.ground = Ground::road;
  world.goal = {100.0, 0.0};
  world.half_size_m = 1000.0;
  return world;
}

struct FaultTest : testing::Test {
  Dbc dbc = parse_dbc(builtin_dbc(), "lagr.dbc");
  SimVehicle vehicle{VehicleParams{}, flat_world(), dbc, {}, 0.6, 1};
  Time now = from_seconds(1.0);
  TickInput input;

  void drive(double seconds, const std::optional<WheelCommand>& command, auto&& after_each) {
    for (const Time until = now + from_seconds(seconds); now < until;) {
      now += SimVehicle::kPeriod;
      vehicle.step(now, command, input);
      after_each();
    }
  }
};

TEST_F(FaultTest, StoppedEncodersLeaveTheOtherMessages) {
  drive(1.0, WheelCommand{0.5, 0.5}, [] {});
  const std::size_t all = input.can.size();
  FaultInjector injector(dbc, {});
  injector.inject(SimFault::wheels_off, input);
  EXPECT_LT(input.can.size(), all);
  VehicleDecoder decoder(dbc, {});
  bool currents = false;
  for (const CanFrame& frame : input.can) {
    const SignalGroups groups = decoder.decode(frame);
    EXPECT_FALSE(groups.has(SignalGroup::wheels));
    currents = currents || groups.has(SignalGroup::currents);
  }
  EXPECT_TRUE(currents);
}

TEST_F(FaultTest, FailedLinesAreReportedOnce) {
  FaultInjector injector(dbc, {});
  injector.inject(SimFault::lines_failed, input);
  injector.inject(SimFault::lines_failed, input);
  ASSERT_EQ(input.reports.size(), 1U);
  EXPECT_EQ(input.reports[0].source, Source::gpio);
  EXPECT_EQ(input.reports[0].state, SourceState::failed);
}

TEST_F(FaultTest, SilentBusSaysNothing) {
  drive(0.5, WheelCommand{0.5, 0.5}, [] {});
  FaultInjector(dbc, {}).inject(SimFault::bus_silent, input);
  EXPECT_TRUE(input.can.empty());
}

TEST_F(FaultTest, VehicleWithoutCommandsRollsOnForTheBasesTimeoutAndItsBraking) {
  drive(4.0, WheelCommand{1.0, 1.0}, [] {});
  StopWatch watch;
  watch.begin(now, vehicle.distance_m());
  drive(5.0, std::nullopt, [&] { watch.see(now, vehicle.speed_mps(), vehicle.distance_m(), std::nullopt); });
  ASSERT_TRUE(watch.to_standstill_s().has_value());
  EXPECT_GT(*watch.to_standstill_s(), to_seconds(SimVehicle::kCommandTimeout));
  EXPECT_GT(watch.rolled_m(), 0.1);
  EXPECT_LT(watch.rolled_m(), 1.5);
}

TEST(StopWatchTest, CountsFromTheLastTimeThatItMovedOrWasToldTo) {
  StopWatch watch;
  watch.begin(from_seconds(10.0), 5.0);
  watch.see(from_seconds(10.1), 0.0, 5.0, WheelCommand{});
  watch.see(from_seconds(10.2), 0.4, 5.1, WheelCommand{0.5, 0.5});
  EXPECT_FALSE(watch.to_zero_s().has_value());
  EXPECT_FALSE(watch.to_standstill_s().has_value());
  watch.see(from_seconds(10.3), 0.2, 5.2, std::nullopt);
  watch.see(from_seconds(10.4), 0.0, 5.25, WheelCommand{});
  watch.see(from_seconds(10.5), 0.0, 5.25, WheelCommand{});
  EXPECT_NEAR(*watch.to_zero_s(), 0.3, 1e-9);
  EXPECT_NEAR(*watch.to_standstill_s(), 0.4, 1e-9);
  EXPECT_NEAR(watch.rolled_m(), 0.25, 1e-9);
}

}  // namespace
}  // namespace hindsight::tools
