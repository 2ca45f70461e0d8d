// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/thread_judge.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "daemon/beating_thread.h"
#include "daemon/tick_consumer.h"

namespace hindsight {
namespace {

using namespace std::chrono_literals;

TEST(ThreadJudge, AThreadThatNeverBeatIsNotMissed) {
  const Heartbeats heartbeats;
  ThreadJudge judge(heartbeats, 1s);
  EXPECT_EQ(judge.look(100s), ThreadVerdict::well);
}

TEST(ThreadJudge, AThreadSilentInTwoLooksHangs) {
  Heartbeats heartbeats;
  ThreadJudge judge(heartbeats, 1s);
  heartbeats.beat(ThreadId::camera, 10s);
  EXPECT_EQ(judge.look(11s), ThreadVerdict::well);
  EXPECT_EQ(judge.look(11100ms), ThreadVerdict::well) << "late for the first time";
  EXPECT_EQ(judge.look(11200ms), ThreadVerdict::hung);
  EXPECT_EQ(judge.culprit(), "camera");
}

TEST(ThreadJudge, APauseOfTheWholeProcessIsNoHang) {
  Heartbeats heartbeats;
  ThreadJudge judge(heartbeats, 1s);
  for (ThreadId thread : {ThreadId::loop, ThreadId::reflex}) heartbeats.beat(thread, 10s);
  EXPECT_EQ(judge.look(60s), ThreadVerdict::well);
  for (ThreadId thread : {ThreadId::loop, ThreadId::reflex}) heartbeats.beat(thread, 60050ms);
  EXPECT_EQ(judge.look(60100ms), ThreadVerdict::well);
}

TEST(ThreadJudge, AnExceptionEndsOneThreadAndIsKnownAtOnce) {
  Heartbeats heartbeats;
  ThreadJudge judge(heartbeats, 1s);
  start_beating_thread(ThreadId::gps, heartbeats, [] { throw std::runtime_error("no more"); }).join();
  EXPECT_EQ(judge.look(1s), ThreadVerdict::died);
  EXPECT_EQ(judge.culprit(), "gps");
}

TEST(ThreadJudge, AConsumerThatThrowsEndsInGoodOrder) {
  Heartbeats heartbeats;
  ThreadJudge judge(heartbeats, 1s);
  TickRecord record;
  {
    TickConsumer consumer(ThreadId::recorder, 2, heartbeats,
                          [](const TickRecord&) { throw std::bad_alloc(); });
    record.hand_out(1);
    ASSERT_TRUE(consumer.offer(&record));
  }
  EXPECT_EQ(judge.look(1s), ThreadVerdict::died);
  EXPECT_EQ(judge.culprit(), "recorder");
}

}  // namespace
}  // namespace hindsight
