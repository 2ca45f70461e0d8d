// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "daemon/live_reflex.h"
#include "daemon/sample_queue.h"

namespace hindsight {

/// From the GPIO thread to reflex and loop: the reflex knows of every edge before it is queued.
class LineSink : public SampleQueue {
 public:
  LineSink(ReflexBoard& board, LiveReflex& reflex) : board_(board), reflex_(reflex) {}
  void on_edge(const LineEdge& edge) override {
    board_.see(edge);
    reflex_.wake();
    SampleQueue::on_edge(edge);
  }
  void on_report(const SourceReport& report) override {
    board_.lines_ok.store(report.state == SourceState::fresh, std::memory_order_relaxed);
    reflex_.wake();
    SampleQueue::on_report(report);
  }
  /// The lines have been looked at, whether they changed or not.
  void looked(Time now) { board_.last_look_at_lines_ns.store(now.count(), std::memory_order_relaxed); }

 private:
  ReflexBoard& board_;
  LiveReflex& reflex_;
};

}  // namespace hindsight
