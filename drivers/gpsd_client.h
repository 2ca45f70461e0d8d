// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <string>

#include "drivers/backoff.h"
#include "drivers/source_reporter.h"

namespace hindsight {

struct GpsParams {
  bool enabled = true;
  std::string host = "127.0.0.1";
  std::string port = "2947";
  double silence_s = 5.0;
  BackoffParams reopen{.first_s = 0.5, .longest_s = 10.0};

  void visit(auto&& param) {
    param("enabled", enabled, YesNo{}, "whether the vehicle has a GPS receiver behind gpsd");
    param("host", host, AnyText{}, "where gpsd runs");
    param("port", port, AnyText{}, "gpsd's TCP port");
    param("silence_s", silence_s, Range{0.5, 600.0}, "without a fix for so long it is stale [s]");
    reopen.visit(param);
  }
};

/// Position fixes from gpsd. GPS is optional, so that its absence, at start or later, is a report (failed)
/// and a new try with growing pauses, never an error.
///
/// Only two- and three-dimensional fixes are delivered; altitude is 0 for the former. They are stamped with
/// the time of arrival: a receiver's own delay is not known here. The standard deviation comes from gpsd's 95
/// % estimates.
class GpsdClient {
 public:
  GpsdClient(const GpsParams& params, SampleSink& sink);
  ~GpsdClient();

  /// Waits up to `timeout` and delivers what came; connects first where there is no connection (which blocks
  /// for as long as the TCP handshake does). Returns early when `stop_fd` (an eventfd, or -1) is readable.
  /// Never throws.
  void service(Time timeout, int stop_fd = -1);

 private:
  struct Connection;  // libgps' own data

  void connect(Time timeout, int stop_fd);
  void drain(Time now);
  void deliver(Time now);
  void fail(Time now, int error_code);

  GpsParams params_;
  SampleSink& sink_;
  SourceReporter reporter_;
  Backoff backoff_;
  std::unique_ptr<Connection> connection_;
  Time last_fix_{};  // or the connection
};

}  // namespace hindsight
