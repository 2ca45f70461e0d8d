// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "drivers/samples.h"

namespace hindsight {

/// Where a driver puts its samples; it never sees who takes them. The calls come from the thread that serves
/// the driver, so a sink that several drivers share must be thread-safe. They must neither block nor throw.
class SampleSink {
 public:
  virtual ~SampleSink() = default;
  virtual void on_frame(FrameRef frame) = 0;
  virtual void on_can(const CanFrame& frame) = 0;
  virtual void on_edge(const LineEdge& edge) = 0;
  virtual void on_fix(const GpsFix& fix) = 0;
  virtual void on_report(const SourceReport& report) = 0;
};

}  // namespace hindsight
