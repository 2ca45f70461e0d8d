// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/tick_ring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace hindsight {
namespace {

using namespace std::chrono_literals;

std::vector<std::uint8_t> tick_of(std::uint64_t index, std::size_t size) {
  return std::vector<std::uint8_t>(size, static_cast<std::uint8_t>(index));
}

TEST(TickRing, KeepsTheNewestWholeAndInOrder) {
  constexpr std::size_t kBytes = 1000;
  std::mt19937 random(7);
  TickRing ring(kBytes);
  for (std::uint64_t index = 0; index < 2000; ++index) {
    const std::size_t size = random() % 300;
    ASSERT_TRUE(ring.push(index, std::chrono::seconds(index), tick_of(index, size)));
    ASSERT_EQ(ring.ticks().back().index, index);
    std::uint64_t expected = ring.ticks().front().index;
    std::size_t held = 0;
    for (const TickRing::Tick& tick : ring.ticks()) {
      ASSERT_EQ(tick.index, expected++);
      ASSERT_TRUE(std::ranges::equal(ring.bytes_of(tick), tick_of(tick.index, tick.size)))
          << "tick " << tick.index;
      held += tick.size;
    }
    ASSERT_TRUE(index < 20 || held > kBytes - 2 * 300) << "it forgets more than it must";
  }
}

TEST(TickRing, RefusesATickLargerThanItself) {
  TickRing ring(100);
  EXPECT_TRUE(ring.push(0, 0s, tick_of(0, 100)));
  EXPECT_FALSE(ring.push(1, 1s, tick_of(1, 101)));
  EXPECT_EQ(ring.ticks().size(), 1U);
}

TEST(TickRing, ForgetsWhatIsOld) {
  TickRing ring(100);
  for (std::uint64_t index = 0; index < 5; ++index)
    ring.push(index, std::chrono::seconds(index), tick_of(index, 10));
  ring.forget_before(3s);
  ASSERT_EQ(ring.ticks().size(), 2U);
  EXPECT_EQ(ring.ticks().front().index, 3U);
}

}  // namespace
}  // namespace hindsight
