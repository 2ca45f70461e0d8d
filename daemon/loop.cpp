// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/loop.h"

#include <ctime>
#include <utility>

#include "daemon/beating_thread.h"
#include "daemon/thread_setup.h"
#include "daemon/unix_clock.h"
#include "drivers/monotonic_clock.h"

namespace hindsight {
namespace {

void sleep_until(Time due) {
  timespec spec{};
  spec.tv_sec = due.count() / 1'000'000'000;
  spec.tv_nsec = due.count() % 1'000'000'000;
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &spec, nullptr);
}

}  // namespace

Memory memory_of(const Robot& robot, std::int64_t utime_us) {
  const PoseEstimate& pose = robot.localisation().estimate();
  Memory memory{robot.learner().snapshot(), {utime_us, pose.gyro_bias_radps, robot.driven().poses()}};
  memory.state.track.push_back(pose.X_WB);
  return memory;
}

Loop::Loop(const Configuration& configuration, Robot& robot, LiveSources& sources, LiveReflex& reflex,
           ReflexBoard& board, TickRecordPool& records, TickConsumer& publisher, TickConsumer* recorder,
           TickConsumer* flight_recorder, Heartbeats& heartbeats)
    : configuration_(configuration),
      robot_(robot),
      sources_(sources),
      reflex_(reflex),
      board_(board),
      records_(records),
      publisher_(publisher),
      recorder_(recorder),
      flight_recorder_(flight_recorder),
      heartbeats_(heartbeats),
      thread_(start_beating_thread(ThreadId::loop, heartbeats, [this] { work(); })) {}

Loop::~Loop() {
  stopping_.store(true);
  thread_.join();
}

void Loop::stop_the_vehicle() { board_.decision.write({DriveCommand{}, monotonic_now(), StopReason::shutdown}); }

void Loop::work() {
  touch_stack();
  keep_this_thread_on(configuration_.robot.loop_cpu);
  make_this_thread_realtime(configuration_.robot.loop_priority);
  try {
    run();
  } catch (...) {
    stop_the_vehicle();  // before anything is said of it
    throw;
  }
  stop_the_vehicle();
}

void Loop::run() {
  const Time period = from_seconds(1.0 / configuration_.robot.loop_rate_hz);
  Time due = monotonic_now() + period;
  while (!stopping_.load(std::memory_order_relaxed)) {
    sleep_until(due);
    tick(due);
    due += period;
    for (const Time now = monotonic_now(); due <= now; due += period) ++timing_.overruns;
  }
}

void Loop::tick(Time due) {
  TickRecord* record = records_.take();
  if (record == nullptr) return;  // cannot be: the pool is larger than the queues; the stale command stops the vehicle
  TickInput& input = record->input;
  input.clear();
  sources_.drain_into(input);
  input.index = index_++;
  input.now = monotonic_now();
  input.utime_us = unix_now_us();
  input.reflex = reflex_.report();
  input.timing = timing_;

  record->outbox.clear();
  const Decision decision = robot_.step(input, record->outbox);
  board_.decision.write(decision);
  record->reason = decision.reason;

  timing_.wake_latency = input.now - due;
  timing_.step_duration = monotonic_now() - input.now;
  status_.reason.store(static_cast<std::uint8_t>(decision.reason), std::memory_order_relaxed);
  status_.behaviour.store(static_cast<std::uint8_t>(robot_.plan().behaviour), std::memory_order_relaxed);
  status_.ticks.store(index_, std::memory_order_relaxed);
  if (robot_.take_save_request()) {
    const std::lock_guard lock(saving_);
    to_save_ = memory_of(robot_, input.utime_us);
  }
  if (sources_ready()) status_.ready.store(true, std::memory_order_relaxed);
  hand_out(record);
  heartbeats_.beat(ThreadId::loop, monotonic_now());
}

void Loop::hand_out(TickRecord* record) {
  record->hand_out(1 + (recorder_ != nullptr) + (flight_recorder_ != nullptr));
  if (!publisher_.offer(record)) record->release();
  if (flight_recorder_ != nullptr && !flight_recorder_->offer(record)) record->release();
  if (recorder_ != nullptr && !recorder_->offer(record)) {
    record->release();
    ++timing_.recorder_dropped;
  }
}

std::optional<Memory> Loop::take_memory_to_save() {
  const std::lock_guard lock(saving_);
  return std::exchange(to_save_, std::nullopt);
}

bool Loop::sources_ready() const {
  const auto seen = [&](Source source) {
    return robot_.sensed().sources[static_cast<std::size_t>(source)] == SourceState::fresh;
  };
  return seen(Source::camera) && seen(Source::can) && seen(Source::gpio);
}

}  // namespace hindsight
