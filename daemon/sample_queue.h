// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <utility>

#include "daemon/spsc_queue.h"
#include "drivers/sample_sink.h"
#include "drivers/tick_input.h"

namespace hindsight {

/// Between one source's thread and the loop. Nothing waits and nothing allocates; what does not fit is counted.
class SampleQueue : public SampleSink {
 public:
  void on_frame(FrameRef frame) override { count(frames_.push(std::move(frame))); }
  void on_can(const CanFrame& frame) override { count(can_.push(frame)); }
  void on_edge(const LineEdge& edge) override { count(edges_.push(edge)); }
  void on_fix(const GpsFix& fix) override { count(fixes_.push(fix)); }
  void on_report(const SourceReport& report) override { count(reports_.push(report)); }
  void on_command(const OperatorCommand& command) { count(commands_.push(command)); }

  /// Called by the loop: appends all that has come, the newest frame only. Never more than `input` has reserved.
  void drain_into(TickInput& input) {
    FrameRef frame;
    while (frames_.pop(frame)) input.frame = std::move(frame);
    drain(can_, input.can);
    drain(edges_, input.edges);
    drain(fixes_, input.fixes);
    drain(reports_, input.reports);
    drain(commands_, input.commands);
  }
  std::uint32_t refused() const { return refused_.load(std::memory_order_relaxed); }

 private:
  template <typename T>
  static void drain(SpscQueue<T>& queue, std::vector<T>& out) {
    T sample;
    while (out.size() < out.capacity() && queue.pop(sample)) out.push_back(sample);
  }
  void count(bool taken) {
    if (!taken) refused_.fetch_add(1, std::memory_order_relaxed);
  }

  SpscQueue<FrameRef> frames_{4};
  SpscQueue<CanFrame> can_{1024};
  SpscQueue<LineEdge> edges_{64};
  SpscQueue<GpsFix> fixes_{16};
  SpscQueue<SourceReport> reports_{16};
  SpscQueue<OperatorCommand> commands_{16};
  std::atomic<std::uint32_t> refused_{0};
};

}  // namespace hindsight
