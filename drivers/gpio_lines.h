// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "drivers/backoff.h"
#include "drivers/device_error.h"
#include "drivers/source_reporter.h"

struct gpiod_chip;
struct gpiod_line;

namespace hindsight {

struct GpioParams {
  std::string chip = "gpiochip0";
  std::string bumper_left = "bumper_left";
  std::string bumper_right = "bumper_right";
  std::string estop = "estop";
  bool bumpers_active_low = false;
  bool estop_active_low = false;
  std::string bias = "as_is";
  BackoffParams reopen;

  void visit(auto&& param) {
    param("chip", chip, AnyText{},
          "GPIO chip: its label (best: numbers change when it is plugged in again), name, number or path");
    param("bumper_left", bumper_left, AnyText{}, "line of the left bumper: its name or offset; empty: none");
    param("bumper_right", bumper_right, AnyText{},
          "line of the right bumper: its name or offset; empty: none");
    param("estop", estop, AnyText{}, "line of the emergency stop: its name or offset; empty: none");
    param("bumpers_active_low", bumpers_active_low, YesNo{}, "a low level means pressed");
    param("estop_active_low", estop_active_low, YesNo{}, "a low level means pressed");
    param("bias", bias, Choices{"as_is", "pull_up", "pull_down", "disable"}, "the lines' resistors");
    reopen.visit(param);
  }
};

/// A chip's line by its name or offset; null where there is none.
gpiod_line* find_gpio_line(gpiod_chip* chip, const std::string& name);

/// Bumpers and emergency stop on GPIO lines: each edge, both ways, with the kernel's time stamp
/// (CLOCK_MONOTONIC since Linux 5.7; a stamp of another clock is replaced by the time of reading).
///
/// Each line's level is delivered as an edge at the opening, and again whenever it differs from the last edge
/// (the kernel keeps 16 edges a line and drops what comes beyond). Reports: fresh after each opening, failed
/// when the chip is gone; then it is opened anew, with growing pauses.
class GpioLines {
 public:
  /// Throws FatalError(kExitNoDevice) that names chip, line and reason: absent or busy.
  GpioLines(const GpioParams& params, SampleSink& sink);
  ~GpioLines();

  /// Waits up to `timeout` for edges and delivers them; also reads the levels, so call it at least every 100
  /// ms or so. Returns early when `stop_fd` (an eventfd, or -1) is readable. Never throws. One thread at a
  /// time.
  void service(Time timeout, int stop_fd = -1);

 private:
  static constexpr std::array<Line, kLineCount> kLines{Line::bumper_left, Line::bumper_right, Line::estop};

  struct ChipCloser {
    void operator()(gpiod_chip* chip) const;
  };
  struct Input {
    gpiod_line* line = nullptr;  // owned by the chip; null: not wired
    std::optional<bool> last;    // the level last delivered
    Time told{};                 // and its stamp
  };

  bool open(DeviceError& error);
  bool open_line(Line which, const std::string& name, bool active_low, DeviceError& error);
  void close();
  void reopen(Time timeout, int stop_fd);
  int read_edges(Line which, Time now);
  int read_level(Line which, Time now);
  /// Delivers a change; false where it is none.
  bool deliver(Line which, bool active, Time stamp);
  void fail(Time now, int error_code);

  GpioParams params_;
  SampleSink& sink_;
  SourceReporter reporter_;
  Backoff backoff_;
  std::unique_ptr<gpiod_chip, ChipCloser> chip_;
  std::array<Input, kLineCount> inputs_;
};

}  // namespace hindsight
