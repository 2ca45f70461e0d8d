// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "drivers/sample_sink.h"

namespace hindsight {

/// Tells the sink when a source's state changes, and, at most every 100 ms, when its count of lost samples
/// grew.
class SourceReporter {
 public:
  SourceReporter(Source source, SampleSink& sink) : sink_(sink) { report_.source = source; }

  SourceState state() const { return report_.state; }

  void fresh(Time now) { change(now, SourceState::fresh, 0); }
  void stale(Time now) { change(now, SourceState::stale, 0); }
  /// `error_code`: errno.
  void failed(Time now, int error_code) { change(now, SourceState::failed, error_code); }

  /// Samples lost since start.
  void set_dropped(std::uint32_t count) { report_.dropped = count; }
  /// Call once per service: sends a grown count of lost samples when it is due.
  void flush(Time now) {
    if (report_.dropped != told_dropped_ && now - report_.stamp >= kPause) tell(now);
  }

 private:
  static constexpr Time kPause = std::chrono::milliseconds(100);

  void change(Time now, SourceState state, int error_code) {
    if (state == report_.state && error_code == report_.error_code) return;
    report_.state = state;
    report_.error_code = error_code;
    tell(now);
  }
  void tell(Time now) {
    report_.stamp = now;
    told_dropped_ = report_.dropped;
    sink_.on_report(report_);
  }

  SampleSink& sink_;
  SourceReport report_;
  std::uint32_t told_dropped_ = 0;
};

}  // namespace hindsight
