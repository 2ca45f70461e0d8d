// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/gpio_lines.h"

#include <fmt/format.h>
#include <gpiod.h>
#include <poll.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "config/exit_code.h"
#include "drivers/monotonic_clock.h"
#include "drivers/wait.h"

namespace hindsight {
namespace {

constexpr std::size_t kEventsAtOnce = 16;  // as many as the kernel keeps
// A kernel stamp older than this when its edge is read is of another clock.
constexpr Time kOldestStamp = std::chrono::seconds(10);

std::size_t index_of(Line line) { return static_cast<std::size_t>(line); }

int request_flags(const std::string& bias, bool active_low) {
  int flags = active_low ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0;
  if (bias == "pull_up") flags |= GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP;
  if (bias == "pull_down") flags |= GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN;
  if (bias == "disable") flags |= GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE;
  return flags;
}

std::optional<unsigned> as_offset(const std::string& name) {
  unsigned offset = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), offset);
  if (error != std::errc{} || end != name.data() + name.size()) return std::nullopt;
  return offset;
}

Time stamp_of(const gpiod_line_event& event, Time now) {
  const Time stamp = std::chrono::seconds(event.ts.tv_sec) + std::chrono::nanoseconds(event.ts.tv_nsec);
  return stamp <= now && stamp > now - kOldestStamp ? stamp : now;
}

}  // namespace

gpiod_line* find_gpio_line(gpiod_chip* chip, const std::string& name) {
  if (const auto offset = as_offset(name)) return gpiod_chip_get_line(chip, *offset);
  return gpiod_chip_find_line(chip, name.c_str());
}

void GpioLines::ChipCloser::operator()(gpiod_chip* chip) const { gpiod_chip_close(chip); }

GpioLines::GpioLines(const GpioParams& params, SampleSink& sink)
    : params_(params), sink_(sink), reporter_(Source::gpio, sink), backoff_(params.reopen) {
  DeviceError error;
  if (!open(error)) throw FatalError(kExitNoDevice, error.message);
}

GpioLines::~GpioLines() = default;

bool GpioLines::open(DeviceError& error) {
  inputs_ = {};
  chip_.reset(gpiod_chip_open_lookup(params_.chip.c_str()));
  if (!chip_) {
    error = DeviceError::from_errno(errno, params_.chip, "GPIO chip cannot be opened");
    return false;
  }
  const bool opened =
      open_line(Line::bumper_left, params_.bumper_left, params_.bumpers_active_low, error) &&
      open_line(Line::bumper_right, params_.bumper_right, params_.bumpers_active_low, error) &&
      open_line(Line::estop, params_.estop, params_.estop_active_low, error);
  if (!opened) {
    close();
    return false;
  }
  const Time now = monotonic_now();
  reporter_.fresh(now);
  for (const Line which : kLines) {
    if (const int code = read_level(which, now); code != 0) {
      error = DeviceError::from_errno(code, params_.chip, "a line cannot be read");
      close();
      return false;
    }
  }
  return true;
}

bool GpioLines::open_line(Line which, const std::string& name, bool active_low, DeviceError& error) {
  if (name.empty()) return true;
  gpiod_line* line = find_gpio_line(chip_.get(), name);
  if (line == nullptr) {
    error = DeviceError::from_errno(errno, params_.chip, fmt::format("there is no line {}", name));
    return false;
  }
  if (gpiod_line_request_both_edges_events_flags(line, "hindsight",
                                                 request_flags(params_.bias, active_low)) != 0) {
    error = DeviceError::from_errno(errno, params_.chip, fmt::format("line {} cannot be had", name));
    return false;
  }
  inputs_[index_of(which)].line = line;
  return true;
}

void GpioLines::service(Time timeout, int stop_fd) {
  if (!chip_) return reopen(timeout, stop_fd);
  std::array<pollfd, kLineCount> fds{};
  for (std::size_t i = 0; i < fds.size(); ++i) {
    fds[i] = {.fd = inputs_[i].line == nullptr ? -1 : gpiod_line_event_get_fd(inputs_[i].line),
              .events = POLLIN | POLLPRI,
              .revents = 0};
  }
  if (!wait_for(fds, timeout, stop_fd)) return;
  const Time now = monotonic_now();
  for (const Line which : kLines) {
    const short events = fds[index_of(which)].revents;
    int code = 0;
    if ((events & POLLIN) != 0)
      code = read_edges(which, now);
    else if (events != 0)
      code = ENODEV;
    if (code == 0) code = read_level(which, now);
    if (code != 0) return fail(now, code);
  }
  backoff_.succeeded();
}

void GpioLines::reopen(Time timeout, int stop_fd) {
  const Time wait = backoff_.remaining(monotonic_now());
  if (!pause_for(std::min(timeout, wait), stop_fd) || wait > timeout) return;
  DeviceError error;
  if (!open(error)) fail(monotonic_now(), error.code);
}

// The kernel reads a line's level some time after its edge, so that both edges of a short pulse tell the
// level after it. Such edges leave the level as it was; they are delivered as one pulse, there and back: a
// touch is not to be missed.
int GpioLines::read_edges(Line which, Time now) {
  std::array<gpiod_line_event, kEventsAtOnce> events;
  Input& input = inputs_[index_of(which)];
  const int count = gpiod_line_event_read_multiple(input.line, events.data(), kEventsAtOnce);
  if (count < 0) return errno;
  const Time told = input.told;
  bool changed = false;
  Time stamp{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    stamp = stamp_of(events[i], now);
    changed |= deliver(which, events[i].event_type == GPIOD_LINE_EVENT_RISING_EDGE, stamp);
  }
  if (!changed && stamp > told) {  // an older edge is one whose level has been read and told before
    const bool level = input.last.value_or(false);
    deliver(which, !level, stamp);
    deliver(which, level, stamp);
  }
  return 0;
}

int GpioLines::read_level(Line which, Time now) {
  gpiod_line* line = inputs_[index_of(which)].line;
  if (line == nullptr) return 0;
  const int level = gpiod_line_get_value(line);
  if (level < 0) return errno;
  deliver(which, level == 1, now);
  return 0;
}

bool GpioLines::deliver(Line which, bool active, Time stamp) {
  Input& input = inputs_[index_of(which)];
  if (input.last == active) return false;
  input.last = active;
  input.told = stamp;
  sink_.on_edge({.stamp = stamp, .line = which, .active = active});
  return true;
}

void GpioLines::close() {
  inputs_ = {};
  chip_.reset();
}

void GpioLines::fail(Time now, int error_code) {
  close();
  backoff_.failed(now);
  reporter_.failed(now, error_code);
}

}  // namespace hindsight
