// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "drivers/sample_sink.h"

namespace hindsight {

/// Keeps all that a driver says.
class RecordingSink : public SampleSink {
 public:
  void on_frame(FrameRef frame) override {
    frame_stamps.push_back(frame->stamp);
    last_frame = std::move(frame);
  }
  void on_can(const CanFrame& frame) override { can.push_back(frame); }
  void on_edge(const LineEdge& edge) override { edges.push_back(edge); }
  void on_fix(const GpsFix& fix) override { fixes.push_back(fix); }
  void on_report(const SourceReport& report) override { reports.push_back(report); }

  bool last_state_is(SourceState state) const { return !reports.empty() && reports.back().state == state; }

  std::vector<Time> frame_stamps;
  FrameRef last_frame;
  std::vector<CanFrame> can;
  std::vector<LineEdge> edges;
  std::vector<GpsFix> fixes;
  std::vector<SourceReport> reports;
};

}  // namespace hindsight
