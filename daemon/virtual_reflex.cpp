// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/virtual_reflex.h"

namespace hindsight {

VirtualReflex::VirtualReflex(const Configuration& configuration)
    : reflex_(configuration.gate, configuration.vehicle), period_(from_seconds(1.0 / configuration.reflex.rate_hz)) {
  board_.bus_ok = true;
  board_.lines_ok = true;
}

void VirtualReflex::step(Time now) {
  board_.last_look_at_lines_ns = now.count();
  const GateOutput output = reflex_.step(now, board_);
  report_.stamp = now;
  report_.left_mps = static_cast<float>(output.command.left_mps);
  report_.right_mps = static_cast<float>(output.command.right_mps);
  report_.stop_reason = static_cast<std::uint8_t>(output.reason);
  ++report_.frames_sent;
}

void VirtualReflex::run_up_to(TickInput& input) {
  if (next_ == Time{}) next_ = input.now;
  auto edge = input.edges.begin();
  for (; next_ <= input.now; next_ += period_) {
    for (; edge != input.edges.end() && edge->stamp <= next_; ++edge) {
      board_.see(*edge);
      step(edge->stamp);
    }
    step(next_);
  }
  for (; edge != input.edges.end(); ++edge) board_.see(*edge);
  input.reflex = report_;
}

}  // namespace hindsight
