// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/reflex.h"

#include <gtest/gtest.h>

namespace hindsight {
namespace {

using namespace std::chrono_literals;

constexpr Time kNow = 100s;

/// Everything permits motion.
void permit(ReflexBoard& board) {
  board.decision.write({{0.5, 0.5}, kNow, StopReason::none});
  board.lines_ok = true;
  board.bus_ok = true;
  board.last_look_at_lines_ns = kNow.count();
}

StopReason reason_of(const ReflexBoard& board, Time now = kNow) {
  return Reflex(GateParams{}, VehicleParams{}).step(now, board).reason;
}

TEST(Reflex, PermitsWhatNothingForbids) {
  ReflexBoard board;
  permit(board);
  EXPECT_EQ(reason_of(board), StopReason::none);
}

TEST(Reflex, LinesThatNobodyLooksAtStop) {
  ReflexBoard board;
  permit(board);
  board.last_look_at_lines_ns = Time(kNow - 240ms).count();
  EXPECT_EQ(reason_of(board), StopReason::none);
  board.last_look_at_lines_ns = Time(kNow - 260ms).count();
  EXPECT_EQ(reason_of(board), StopReason::gpio);
}

TEST(Reflex, ABusThatTakesNoFramesStops) {
  ReflexBoard board;
  permit(board);
  board.bus_takes_frames = false;
  EXPECT_EQ(reason_of(board), StopReason::can_bus);
}

TEST(Reflex, ALostThreadStops) {
  ReflexBoard board;
  permit(board);
  board.thread_lost = true;
  EXPECT_EQ(reason_of(board), StopReason::thread);
}

}  // namespace
}  // namespace hindsight
