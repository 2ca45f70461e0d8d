// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <thread>

#include "daemon/latest.h"
#include "daemon/spsc_queue.h"

namespace hindsight {
namespace {

TEST(SpscQueue, RefusesWhenFullAndKeepsOrder) {
  SpscQueue<int> queue(2);
  EXPECT_TRUE(queue.push(1));
  EXPECT_TRUE(queue.push(2));
  EXPECT_FALSE(queue.push(3));
  int value = 0;
  EXPECT_TRUE(queue.pop(value) && value == 1);
  EXPECT_TRUE(queue.push(4));
  EXPECT_TRUE(queue.pop(value) && value == 2);
  EXPECT_TRUE(queue.pop(value) && value == 4);
  EXPECT_FALSE(queue.pop(value));
}

TEST(SpscQueue, NothingIsLostOrDoubledBetweenThreads) {
  constexpr int kCount = 200000;
  SpscQueue<int> queue(64);
  std::thread producer([&] {
    for (int i = 0; i < kCount; ++i) {
      while (!queue.push(i)) std::this_thread::yield();
    }
  });
  for (int expected = 0; expected < kCount;) {
    int value = -1;
    if (queue.pop(value)) {
      ASSERT_EQ(value, expected++);
    } else {
      std::this_thread::yield();
    }
  }
  producer.join();
}

TEST(Latest, AReaderNeverSeesHalfAValue) {
  struct Pair {
    long a = 0;
    long b = 0;
    double c = 0.0;
  };
  Latest<Pair> latest;
  std::atomic<bool> done{false};
  std::thread writer([&] {
    for (long i = 0; i < 200000; ++i) latest.write({i, -i, static_cast<double>(i)});
    done = true;
  });
  long newest = 0;
  while (!done) {
    const Pair value = latest.read();
    ASSERT_EQ(value.a, -value.b);
    ASSERT_EQ(value.c, static_cast<double>(value.a));
    ASSERT_GE(value.a, newest);
    newest = value.a;
  }
  writer.join();
  EXPECT_EQ(latest.read().a, 199999);
}

}  // namespace
}  // namespace hindsight
