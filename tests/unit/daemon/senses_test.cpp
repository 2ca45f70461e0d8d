// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/senses.h"

#include <gtest/gtest.h>

namespace hindsight {
namespace {

using namespace std::chrono_literals;

class SensesTest : public testing::Test {
 protected:
  const Sensed& at(Time now) {
    input_.now = now;
    const Sensed& sensed = senses_.update(input_);
    input_.clear();
    return sensed;
  }
  void edge(Time stamp, bool active) { input_.edges.push_back({stamp, Line::bumper_left, active}); }

  Configuration configuration_;
  Senses senses_{configuration_, read_dbc(HINDSIGHT_SOURCE_DIR "/config/lagr.dbc")};
  TickInput input_;
};

TEST_F(SensesTest, ABumperIsStuckUntilItWasSeenReleased) {
  edge(1s, true);
  EXPECT_TRUE(at(1s).is_stuck(Line::bumper_left));
  EXPECT_FALSE(at(1s).is_stuck(Line::bumper_right));
  edge(2s, false);
  EXPECT_FALSE(at(2s).is_stuck(Line::bumper_left));
  edge(3s, true);
  EXPECT_FALSE(at(3s).is_stuck(Line::bumper_left)) << "a touch";
  input_.reports.push_back({4s, Source::gpio, SourceState::failed, 0, ENODEV});
  EXPECT_TRUE(at(4s).is_stuck(Line::bumper_left))
      << "the lines are opened anew: what was seen no longer counts";
}

TEST_F(SensesTest, GpsIsLostAfterItsTimeAndOnlyIfItWasThere) {
  EXPECT_FALSE(at(1000s).gps_lost) << "never seen: not needed";
  input_.fixes.push_back({.stamp = 1000s});
  EXPECT_FALSE(at(1000s).gps_lost);
  EXPECT_FALSE(at(1060s).gps_lost);
  EXPECT_TRUE(at(1061s).gps_lost);
  input_.fixes.push_back({.stamp = 1062s});
  EXPECT_FALSE(at(1062s).gps_lost);
}

}  // namespace
}  // namespace hindsight
