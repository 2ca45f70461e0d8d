// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/reflex.h"

namespace hindsight {
namespace {

/// Five services of the GPIO thread. Whether a bumper is pressed is then no longer known.
constexpr Time kLinesTimeout = from_seconds(0.25);

bool lines_known(Time now, const ReflexBoard& board) {
  const Time last_look(board.last_look_at_lines_ns.load(std::memory_order_relaxed));
  return board.lines_ok.load(std::memory_order_relaxed) && now - last_look <= kLinesTimeout;
}

bool bus_works(const ReflexBoard& board) {
  return board.bus_ok.load(std::memory_order_relaxed) && board.bus_takes_frames.load(std::memory_order_relaxed);
}

}  // namespace

void ReflexBoard::see(const LineEdge& edge) {
  // The time first: a reader that sees the line pressed must not see an older edge.
  std::atomic<Time::rep>& last_edge_ns = edge.line == Line::estop ? last_estop_edge_ns : last_bumper_edge_ns;
  if (edge.active) last_edge_ns.store(edge.stamp.count(), std::memory_order_relaxed);
  line_active[static_cast<std::size_t>(edge.line)].store(edge.active, std::memory_order_release);
}

GateOutput Reflex::step(Time now, const ReflexBoard& board) {
  const Decision decision = board.decision.read();
  GateInput input;
  input.now = now;
  input.wanted = decision.command;
  input.decided_at = decision.decided_at;
  input.loop_reason = board.thread_lost.load(std::memory_order_relaxed) ? StopReason::thread : decision.reason;
  input.estop_active = board.active(Line::estop);
  input.bumper_active = board.active(Line::bumper_left) || board.active(Line::bumper_right);
  input.last_bumper_edge = Time(board.last_bumper_edge_ns.load(std::memory_order_relaxed));
  input.last_estop_edge = Time(board.last_estop_edge_ns.load(std::memory_order_relaxed));
  input.lines_ok = lines_known(now, board);
  input.bus_ok = bus_works(board);
  return gate_.step(input);
}

}  // namespace hindsight
