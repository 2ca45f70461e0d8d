// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/can_stamp.h"

#include <gtest/gtest.h>

namespace hindsight {
namespace {

using std::chrono::milliseconds;

constexpr Time kNow = milliseconds(5000);
constexpr Time kLastEmpty = milliseconds(4900);
constexpr Time kWall = std::chrono::hours(490000);

TEST(CanStamp, IsNowLessTheAge) {
  EXPECT_EQ(monotonic_stamp(kWall - milliseconds(3), kWall, kNow, kLastEmpty), kNow - milliseconds(3));
}

TEST(CanStamp, AStepOfTheWallClockMovesItWithinTheWaitOnly) {
  EXPECT_EQ(monotonic_stamp(kWall + std::chrono::hours(1), kWall, kNow, kLastEmpty), kNow);
  EXPECT_EQ(monotonic_stamp(kWall - std::chrono::hours(1), kWall, kNow, kLastEmpty), kLastEmpty);
}

}  // namespace
}  // namespace hindsight
