// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The fast half of the robot: 100 times a second, and at once on an edge of bumper or e-stop, it passes the loop's
// latest set-point through the command gate. No vision, no allocation, no lock. Pure but for the board that it reads:
// the live thread (live_reflex) and the replay (replay_run) drive the same class.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "daemon/command_gate.h"
#include "daemon/latest.h"
#include "drivers/tick_input.h"

namespace hindsight {

/// What the loop decided, and when.
struct Decision {
  DriveCommand command;
  Time decided_at{};
  StopReason reason = StopReason::not_armed;
};

/// Where the other threads put what the reflex must know. Each member has one writing thread.
struct ReflexBoard {
  Latest<Decision> decision;                                 ///< loop
  std::array<std::atomic<bool>, kLineCount> line_active{};   ///< GPIO thread
  std::atomic<Time::rep> last_bumper_edge_ns{0};             ///< GPIO thread
  std::atomic<Time::rep> last_estop_edge_ns{0};              ///< GPIO thread
  std::atomic<bool> lines_ok{false};                         ///< GPIO thread
  std::atomic<Time::rep> last_look_at_lines_ns{0};           ///< GPIO thread; grows old when that thread hangs
  std::atomic<bool> bus_ok{false};                           ///< CAN thread
  std::atomic<bool> bus_takes_frames{true};                  ///< reflex thread
  std::atomic<bool> thread_lost{false};                      ///< main thread, which judges all the others; for good

  /// Takes over one edge; called by the thread that owns the lines.
  void see(const LineEdge& edge);
  bool active(Line line) const { return line_active[static_cast<std::size_t>(line)].load(std::memory_order_acquire); }
};

struct ReflexParams {
  double rate_hz = 100.0;
  int realtime_priority = 50;
  int cpu = -1;

  void visit(auto&& param) {
    param("rate_hz", rate_hz, Range{20.0, 1000.0}, "how often a set-point goes to the bus [Hz]");
    param("realtime_priority", realtime_priority, Range{0, 99}, "SCHED_FIFO priority of reflex and GPIO lines; 0: none");
    param("cpu", cpu, Range{-1, 1023}, "processor that the reflex stays on; -1: any");
  }
};

class Reflex {
 public:
  Reflex(const GateParams& gate, const VehicleParams& vehicle) : gate_(gate, vehicle) {}

  /// The set-point that may go to the bus at `now`.
  GateOutput step(Time now, const ReflexBoard& board);

 private:
  CommandGate gate_;
};

}  // namespace hindsight
