// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/senses.h"

#include <gtest/gtest.h>

#include "drivers/frame_pool.h"

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

TEST_F(SensesTest, APictureThatComesAgainIsNoNewOne) {
  FramePool pool(3, 0, 0);
  const auto picture = [&](Time stamp, int row, std::uint8_t value) {
    input_.frame = pool.take();
    Frame& frame = input_.frame.writable();
    frame.stamp = stamp, frame.width_px = 4, frame.height_px = 40;
    frame.bgr.assign(480, 0);
    frame.bgr[static_cast<std::size_t>(12 * row + 7)] = value;
    return at(stamp);
  };
  EXPECT_TRUE(picture(1000ms, 32, 1).new_picture);
  EXPECT_TRUE(picture(1100ms, 32, 2).new_picture);
  EXPECT_TRUE(picture(1200ms, 16, 2).new_picture);
  EXPECT_FALSE(picture(1300ms, 16, 2).new_picture);
  EXPECT_EQ(picture(1500ms, 16, 2).sources[0], SourceState::fresh);
  EXPECT_EQ(picture(1501ms, 16, 2).sources[0], SourceState::stale) << "as if no frames came";
  EXPECT_EQ(picture(1600ms, 16, 3).sources[0], SourceState::fresh);
  EXPECT_FALSE(at(1700ms).new_picture);
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
