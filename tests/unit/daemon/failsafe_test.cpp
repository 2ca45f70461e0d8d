// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/failsafe.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace hindsight {
namespace {

FailsafeInput healthy() {
  FailsafeInput input;
  input.sources.fill(SourceState::fresh);
  input.wheels_fresh = true;
  return input;
}

StopReason step_with(Failsafe& failsafe, FailsafeInput input, CommandKind kind) {
  const OperatorCommand command{Time{}, kind, 0.0, 0.0, 1};
  input.commands = std::span(&command, 1);
  return failsafe.step(input);
}

FailsafeInput without(Source source) {
  FailsafeInput input = healthy();
  input.sources[static_cast<std::size_t>(source)] = SourceState::stale;
  return input;
}

TEST(Failsafe, IsNotArmedUntilAnOperatorArms) {
  Failsafe failsafe{FailsafeParams{}};
  EXPECT_EQ(failsafe.step(healthy()), StopReason::not_armed);
  EXPECT_EQ(step_with(failsafe, healthy(), CommandKind::arm), StopReason::none);
  EXPECT_TRUE(failsafe.armed());
}

TEST(Failsafe, ArmsByItselfOnceWhereConfigured) {
  Failsafe failsafe{FailsafeParams{.arm_at_start = true}};
  EXPECT_NE(failsafe.step(without(Source::camera)), StopReason::none);
  EXPECT_EQ(failsafe.step(healthy()), StopReason::none);
  EXPECT_EQ(failsafe.step(without(Source::camera)), StopReason::camera);
  EXPECT_EQ(failsafe.step(healthy()), StopReason::camera) << "a stop stays until an operator arms";
}

TEST(Failsafe, AnOperatorStopCancelsArmingAtStart) {
  Failsafe failsafe{FailsafeParams{.arm_at_start = true}};
  EXPECT_EQ(step_with(failsafe, without(Source::camera), CommandKind::stop), StopReason::operator_stop);
  EXPECT_EQ(failsafe.step(healthy()), StopReason::operator_stop);
}

TEST(Failsafe, EachLostSourceStopsAndIsLatched) {
  const std::pair<Source, StopReason> rows[] = {
      {Source::gpio, StopReason::gpio}, {Source::can, StopReason::can_bus}, {Source::camera, StopReason::camera}};
  for (const auto& [source, reason] : rows) {
    Failsafe failsafe{FailsafeParams{.arm_at_start = true}};
    ASSERT_EQ(failsafe.step(healthy()), StopReason::none);
    EXPECT_EQ(failsafe.step(without(source)), reason);
    EXPECT_EQ(failsafe.step(healthy()), reason) << "latched";
    EXPECT_EQ(step_with(failsafe, without(source), CommandKind::arm), reason) << "refused while the cause lasts";
    EXPECT_EQ(step_with(failsafe, healthy(), CommandKind::arm), StopReason::none);
  }
}

TEST(Failsafe, StaleWheelsStop) {
  Failsafe failsafe{FailsafeParams{.arm_at_start = true}};
  failsafe.step(healthy());
  FailsafeInput input = healthy();
  input.wheels_fresh = false;
  EXPECT_EQ(failsafe.step(input), StopReason::wheels);
}

TEST(Failsafe, ABumperStuckSinceTheStartRefusesArmingByName) {
  Failsafe failsafe{FailsafeParams{}};
  FailsafeInput input = healthy();
  input.bumper_left_stuck = true;
  EXPECT_EQ(step_with(failsafe, input, CommandKind::arm), StopReason::bumper_left_stuck);
  input = healthy();
  input.bumper_right_stuck = true;
  EXPECT_EQ(step_with(failsafe, input, CommandKind::arm), StopReason::bumper_right_stuck);
  EXPECT_EQ(step_with(failsafe, healthy(), CommandKind::arm), StopReason::none);
}

TEST(Failsafe, WhatTheReflexLostBetweenTicksIsLatched) {
  for (const StopReason lost : {StopReason::gpio, StopReason::can_bus}) {
    Failsafe failsafe{FailsafeParams{.arm_at_start = true}};
    failsafe.step(healthy());
    FailsafeInput input = healthy();
    input.reflex_reason = lost;
    EXPECT_EQ(failsafe.step(input), lost);
    EXPECT_EQ(failsafe.step(healthy()), lost) << "latched";
    EXPECT_EQ(step_with(failsafe, healthy(), CommandKind::arm), StopReason::none);
  }
}

TEST(Failsafe, GpsLostForTooLongStopsAndIsLatched) {
  Failsafe failsafe{FailsafeParams{.arm_at_start = true}};
  failsafe.step(healthy());
  FailsafeInput input = healthy();
  input.gps_lost = true;
  EXPECT_EQ(failsafe.step(input), StopReason::gps);
  EXPECT_EQ(step_with(failsafe, input, CommandKind::arm), StopReason::gps);
  EXPECT_EQ(failsafe.step(healthy()), StopReason::gps) << "latched";
  EXPECT_EQ(step_with(failsafe, healthy(), CommandKind::arm), StopReason::none);
}

TEST(Failsafe, ABumperSeenByTheReflexStopsNothingHere) {
  Failsafe failsafe{FailsafeParams{.arm_at_start = true}};
  FailsafeInput input = healthy();
  input.reflex_reason = StopReason::bumper;
  EXPECT_EQ(failsafe.step(input), StopReason::none);
}

TEST(Failsafe, GpsAndOperatorLinkAreNotRequired) {
  Failsafe failsafe{FailsafeParams{.arm_at_start = true}};
  FailsafeInput input = without(Source::gps);
  input.sources[static_cast<std::size_t>(Source::operator_link)] = SourceState::failed;
  EXPECT_EQ(failsafe.step(input), StopReason::none);
}

TEST(Failsafe, EstopNeedsReleaseAndThenArm) {
  Failsafe failsafe{FailsafeParams{.arm_at_start = true}};
  failsafe.step(healthy());
  FailsafeInput pressed = healthy();
  pressed.estop_active = true;
  EXPECT_EQ(failsafe.step(pressed), StopReason::estop);
  EXPECT_EQ(step_with(failsafe, pressed, CommandKind::release_estop), StopReason::estop);
  EXPECT_EQ(failsafe.step(healthy()), StopReason::estop);
  EXPECT_EQ(step_with(failsafe, healthy(), CommandKind::arm), StopReason::estop);
  EXPECT_EQ(step_with(failsafe, healthy(), CommandKind::release_estop), StopReason::not_armed);
  EXPECT_EQ(step_with(failsafe, healthy(), CommandKind::arm), StopReason::none);
}

TEST(Failsafe, AnEstopCancelsArmingAtStart) {
  Failsafe failsafe{FailsafeParams{.arm_at_start = true}};
  FailsafeInput pressed = healthy();
  pressed.estop_active = true;
  EXPECT_EQ(failsafe.step(pressed), StopReason::estop);
  EXPECT_EQ(step_with(failsafe, healthy(), CommandKind::release_estop), StopReason::not_armed);
  EXPECT_EQ(failsafe.step(healthy()), StopReason::not_armed) << "a release is not an arm";
}

TEST(Failsafe, AnEstopStaysTheReasonUntilItsRelease) {
  Failsafe failsafe{FailsafeParams{}};
  FailsafeInput pressed = healthy();
  pressed.estop_active = true;
  EXPECT_EQ(step_with(failsafe, pressed, CommandKind::stop), StopReason::estop);
  EXPECT_EQ(step_with(failsafe, healthy(), CommandKind::stop), StopReason::estop);
  EXPECT_EQ(step_with(failsafe, healthy(), CommandKind::disarm), StopReason::estop);
}

TEST(Failsafe, StopsAfterTooManyOverrunsInARowOnly) {
  Failsafe failsafe{FailsafeParams{.max_overruns = 2, .arm_at_start = true}};
  failsafe.step(healthy());
  FailsafeInput late = healthy();
  late.overrun = true;
  EXPECT_EQ(failsafe.step(late), StopReason::none);
  EXPECT_EQ(failsafe.step(late), StopReason::none);
  EXPECT_EQ(failsafe.step(healthy()), StopReason::none);
  EXPECT_EQ(failsafe.step(late), StopReason::none);
  EXPECT_EQ(failsafe.step(late), StopReason::none);
  EXPECT_EQ(failsafe.step(late), StopReason::overruns);
}

// Over random histories: motion is permitted only while every required input is healthy, and a stop ends only in
// a tick in which an operator armed.
TEST(Failsafe, PermitsNothingWhileACauseLasts) {
  std::mt19937 random(20240817);
  Failsafe failsafe{FailsafeParams{}};
  StopReason last = StopReason::not_armed;
  for (int i = 0; i < 200000; ++i) {
    FailsafeInput input = healthy();
    for (auto& source : input.sources) {
      if (random() % 16 == 0) source = static_cast<SourceState>(random() % 5);
    }
    input.wheels_fresh = random() % 16 != 0;
    input.estop_active = random() % 64 == 0;
    std::vector<OperatorCommand> commands(random() % 3);
    bool arm = false;
    for (auto& command : commands) {
      command.kind = static_cast<CommandKind>(random() % 8);
      arm = arm || command.kind == CommandKind::arm;
    }
    input.commands = commands;
    const StopReason reason = failsafe.step(input);
    if (reason == StopReason::none) {
      ASSERT_FALSE(input.estop_active);
      ASSERT_TRUE(input.wheels_fresh);
      for (Source source : {Source::camera, Source::can, Source::gpio}) {
        ASSERT_EQ(input.sources[static_cast<std::size_t>(source)], SourceState::fresh);
      }
      ASSERT_TRUE(last == StopReason::none || arm);
    }
    ASSERT_EQ(failsafe.armed(), reason == StopReason::none);
    last = reason;
  }
}

}  // namespace
}  // namespace hindsight
