// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/live_reflex.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <array>

#include "daemon/beating_thread.h"
#include "daemon/thread_setup.h"
#include "drivers/monotonic_clock.h"

namespace hindsight {
namespace {

/// A bus that has refused so many set-points in a row takes none: at the reflex's rate, a tenth of a second.
constexpr int kMostRefusedInARow = 10;

/// Does something when the scope ends, also by an exception.
template <typename Action>
struct LastWord {
  Action action;
  ~LastWord() { action(); }
};
template <typename Action>
LastWord(Action) -> LastWord<Action>;

UniqueFd periodic_timer(double rate_hz) {
  UniqueFd timer(timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK));
  itimerspec spec{};
  spec.it_interval.tv_nsec = static_cast<long>(1e9 / rate_hz);
  spec.it_value = spec.it_interval;
  timerfd_settime(timer.get(), 0, &spec, nullptr);
  return timer;
}

void drain(const UniqueFd& fd) {
  std::uint64_t count = 0;
  static_cast<void>(!read(fd.get(), &count, sizeof count));
}

}  // namespace

LiveReflex::LiveReflex(const Configuration& configuration, const Dbc& dbc, ReflexBoard& board, Heartbeats& heartbeats)
    : configuration_(configuration),
      board_(board),
      heartbeats_(heartbeats),
      codec_(dbc, configuration.can_roles),
      sender_(configuration.can.interface, configuration.can.reopen),
      reflex_(configuration.gate, configuration.vehicle),
      timer_(periodic_timer(configuration.reflex.rate_hz)),
      wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      thread_(start_beating_thread(ThreadId::reflex, heartbeats, [this] { work(); })) {}

LiveReflex::~LiveReflex() {
  stopping_.store(true);
  wake();
  thread_.join();
}

void LiveReflex::wake() {
  const std::uint64_t one = 1;
  static_cast<void>(!write(wake_.get(), &one, sizeof one));
}

void LiveReflex::send(const WheelSetpoints& set_points, Time now) {
  const bool taken = sender_.send(codec_.encode(set_points, sender_.counts().sent), now) == 0;
  refused_in_a_row_ = taken ? 0 : refused_in_a_row_ + 1;
  board_.bus_takes_frames.store(refused_in_a_row_ < kMostRefusedInARow, std::memory_order_relaxed);
}

void LiveReflex::act() {
  const Time now = monotonic_now();
  const GateOutput output = reflex_.step(now, board_);
  send({output.command.left_mps, output.command.right_mps, output.reason == StopReason::none}, now);
  const SendCounts& counts = sender_.counts();
  report_.write({now, static_cast<float>(output.command.left_mps), static_cast<float>(output.command.right_mps),
                 static_cast<std::uint8_t>(output.reason), counts.sent, counts.queue_full + counts.failed});
  heartbeats_.beat(ThreadId::reflex, now);
}

void LiveReflex::work() {
  touch_stack();
  keep_this_thread_on(configuration_.reflex.cpu);
  make_this_thread_realtime(configuration_.reflex.realtime_priority);
  // Whatever ends this thread, its last word is zero.
  const LastWord zero{[this] { send({}, monotonic_now()); }};
  while (!stopping_.load()) {
    std::array<pollfd, 2> events{{{timer_.get(), POLLIN, 0}, {wake_.get(), POLLIN, 0}}};
    poll(events.data(), events.size(), 1000);
    drain(timer_);
    drain(wake_);
    act();
  }
}

}  // namespace hindsight
