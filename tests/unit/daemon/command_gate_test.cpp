// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/command_gate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace hindsight {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

GateInput permitted(double left_mps, double right_mps, Time now = from_seconds(1.0)) {
  GateInput input;
  input.now = now;
  input.wanted = {left_mps, right_mps};
  input.decided_at = now;
  input.loop_reason = StopReason::none;
  input.lines_ok = true;
  input.bus_ok = true;
  return input;
}

/// A gate that has been driving at these speeds for a while.
CommandGate driving(double left_mps, double right_mps) {
  CommandGate gate{GateParams{}, VehicleParams{}};
  for (int i = 0; i < 200; ++i) gate.step(permitted(left_mps, right_mps, from_seconds(i * 0.01)));
  return gate;
}

void expect_stop(const GateInput& input, StopReason reason) {
  CommandGate gate = driving(0.5, 0.5);
  GateInput later = input;
  const GateOutput output = gate.step(later);
  EXPECT_EQ(output.reason, reason);
  EXPECT_EQ(output.command.left_mps, 0.0);
  EXPECT_EQ(output.command.right_mps, 0.0);
}

TEST(CommandGate, PassesAPermittedCommand) {
  CommandGate gate = driving(0.5, 0.4);
  const GateOutput output = gate.step(permitted(0.5, 0.4, from_seconds(2.0)));
  EXPECT_EQ(output.reason, StopReason::none);
  EXPECT_EQ(output.command.left_mps, 0.5);
  EXPECT_EQ(output.command.right_mps, 0.4);
}

TEST(CommandGate, EachCauseStopsAtOnce) {
  GateInput input = permitted(0.5, 0.5, from_seconds(2.0));
  input.estop_active = true;
  expect_stop(input, StopReason::estop);
  input = permitted(0.5, 0.5, from_seconds(2.0));
  input.loop_reason = StopReason::camera;
  expect_stop(input, StopReason::camera);
  input = permitted(0.5, 0.5, from_seconds(2.0));
  input.lines_ok = false;
  expect_stop(input, StopReason::gpio);
  input = permitted(0.5, 0.5, from_seconds(2.0));
  input.bus_ok = false;
  expect_stop(input, StopReason::can_bus);
  input = permitted(0.5, 0.5, from_seconds(2.0));
  input.decided_at = from_seconds(1.7);
  expect_stop(input, StopReason::stale_command);
  for (double bad : {kNan, kInfinity, -kInfinity}) {
    expect_stop(permitted(bad, 0.5, from_seconds(2.0)), StopReason::bad_command);
    expect_stop(permitted(0.5, bad, from_seconds(2.0)), StopReason::bad_command);
  }
}

TEST(CommandGate, ACommandIsFreshUpToItsTimeout) {
  CommandGate gate = driving(0.5, 0.5);
  GateInput input = permitted(0.5, 0.5, from_seconds(2.25));
  input.decided_at = from_seconds(2.0);
  EXPECT_EQ(gate.step(input).reason, StopReason::none);
  input.now += Time(1);
  EXPECT_EQ(gate.step(input).reason, StopReason::stale_command);
}

TEST(CommandGate, ABumperEdgeHoldsUntilTheLoopKnowsOfIt) {
  GateInput input = permitted(-0.3, -0.3, from_seconds(2.0));
  input.last_bumper_edge = from_seconds(1.99);
  input.decided_at = from_seconds(1.95);
  expect_stop(input, StopReason::bumper);
  CommandGate gate = driving(-0.3, -0.3);
  input.decided_at = from_seconds(1.99);
  input.bumper_active = true;
  EXPECT_EQ(gate.step(input).reason, StopReason::none) << "backing off a pressed bumper is allowed";
}

TEST(CommandGate, AnEstopThatIsOverHoldsUntilTheLoopKnowsOfIt) {
  GateInput input = permitted(0.3, 0.3, from_seconds(2.0));
  input.last_estop_edge = from_seconds(1.99);
  input.decided_at = from_seconds(1.95);
  expect_stop(input, StopReason::estop);
  CommandGate gate = driving(0.3, 0.3);
  input.decided_at = from_seconds(1.99);
  EXPECT_EQ(gate.step(input).reason, StopReason::none) << "what the loop makes of it, it has decided";
}

TEST(CommandGate, NoWheelRunsForwardAgainstAPressedBumper) {
  for (const auto& [left, right] : {std::pair{0.3, 0.3}, {0.3, -0.3}, {-0.3, 0.1}}) {
    GateInput input = permitted(left, right, from_seconds(2.0));
    input.bumper_active = true;
    expect_stop(input, StopReason::bumper);
  }
}

TEST(CommandGate, LimitsSpeedAndSpeedingUpButNotSlowingDown) {
  const VehicleParams vehicle;
  CommandGate gate{GateParams{}, vehicle};
  gate.step(permitted(0.0, 0.0, from_seconds(1.0)));
  GateOutput output = gate.step(permitted(9.0, -9.0, from_seconds(1.01)));
  EXPECT_NEAR(output.command.left_mps, vehicle.max_acceleration_mps2 * 0.01, 1e-12);
  EXPECT_NEAR(output.command.right_mps, -vehicle.max_acceleration_mps2 * 0.01, 1e-12);
  gate = driving(9.0, -9.0);
  output = gate.step(permitted(9.0, -9.0, from_seconds(2.0)));
  EXPECT_EQ(output.command.left_mps, vehicle.max_speed_mps);
  EXPECT_EQ(output.command.right_mps, -vehicle.max_speed_mps);
  output = gate.step(permitted(0.1, 0.0, from_seconds(2.01)));
  EXPECT_EQ(output.command.left_mps, 0.1);
  EXPECT_EQ(output.command.right_mps, 0.0);
}

TEST(CommandGate, ReversalGoesThroughZero) {
  CommandGate gate = driving(0.5, 0.5);
  EXPECT_EQ(gate.step(permitted(-0.5, -0.5, from_seconds(2.0))).command.left_mps, 0.0);
  EXPECT_LT(gate.step(permitted(-0.5, -0.5, from_seconds(2.01))).command.left_mps, 0.0);
}

TEST(CommandGate, APauseDoesNotOpenTheSlewLimit) {
  const VehicleParams vehicle;
  CommandGate gate{GateParams{}, vehicle};
  gate.step(permitted(0.0, 0.0, from_seconds(1.0)));
  EXPECT_LE(gate.step(permitted(1.0, 1.0, from_seconds(100.0))).command.left_mps,
            vehicle.max_acceleration_mps2 * 0.1 + 1e-12);
  EXPECT_EQ(gate.step(permitted(-1.0, 1.0, from_seconds(50.0))).reason, StopReason::none) << "time going back";
}

// Whatever comes in: finite, within speed and slew, and zero whenever a reason is given.
TEST(CommandGate, NothingButPermittedCommandsComeOut) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> speed(-3.0, 3.0);
  const VehicleParams vehicle;
  CommandGate gate{GateParams{}, vehicle};
  Time now = from_seconds(10.0);
  DriveCommand last;
  gate.step(permitted(0.0, 0.0, now));
  for (int i = 0; i < 300000; ++i) {
    const double dt_s = static_cast<double>(random() % 30) * 1e-3;
    now += from_seconds(dt_s);
    GateInput input = permitted(speed(random), speed(random), now);
    if (random() % 20 == 0) input.wanted.left_mps = kNan;
    if (random() % 20 == 0) input.wanted.right_mps = kInfinity;
    input.decided_at = now - from_seconds(static_cast<double>(random() % 300) * 1e-3);
    input.last_bumper_edge = now - from_seconds(static_cast<double>(random() % 3000) * 1e-3);
    input.loop_reason = random() % 8 == 0 ? static_cast<StopReason>(random() % kStopReasonCount) : StopReason::none;
    input.estop_active = random() % 50 == 0;
    input.bumper_active = random() % 10 == 0;
    input.lines_ok = random() % 50 != 0;
    input.bus_ok = random() % 50 != 0;
    const GateOutput output = gate.step(input);
    const auto [left, right] = output.command;
    const bool may_move = !input.estop_active && input.lines_ok && input.bus_ok &&
                          input.loop_reason == StopReason::none && input.decided_at >= input.last_bumper_edge &&
                          now - input.decided_at <= from_seconds(0.25) && std::isfinite(input.wanted.left_mps) &&
                          std::isfinite(input.wanted.right_mps);
    if (!may_move || output.reason != StopReason::none) {
      ASSERT_NE(output.reason, StopReason::none);
      ASSERT_TRUE(left == 0.0 && right == 0.0);
    }
    ASSERT_FALSE(input.bumper_active && (left > 0.0 || right > 0.0));
    for (const auto& [value, before] : {std::pair{left, last.left_mps}, {right, last.right_mps}}) {
      ASSERT_LE(std::abs(value), vehicle.max_speed_mps);
      ASSERT_LE(std::abs(value) - std::abs(before), vehicle.max_acceleration_mps2 * dt_s + 1e-9);
    }
    last = output.command;
  }
}

}  // namespace
}  // namespace hindsight
