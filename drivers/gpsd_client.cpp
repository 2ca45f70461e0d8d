// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/gpsd_client.h"

#include <gps.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drivers/monotonic_clock.h"
#include "drivers/wait.h"

namespace hindsight {
namespace {

// gpsd's estimates hold in 95 % of cases: so many standard deviations in one dimension, and in two.
constexpr double kSigmas1d = 1.9600;
constexpr double kSigmas2d = 2.4477;

double horizontal_sigma(const gps_fix_t& fix) {
  if (std::isfinite(fix.epx) && std::isfinite(fix.epy))
    return std::hypot(fix.epx, fix.epy) / std::sqrt(2.0) / kSigmas1d;
  return std::isfinite(fix.eph) ? fix.eph / kSigmas2d : 0.0;
}

bool has_position(const gps_data_t& data) {
  return (data.set & MODE_SET) != 0 && (data.set & LATLON_SET) != 0 && data.fix.mode >= MODE_2D &&
         std::isfinite(data.fix.latitude) && std::isfinite(data.fix.longitude);
}

}  // namespace

struct GpsdClient::Connection {
  gps_data_t data{};
  bool open = false;

  ~Connection() { close(); }
  void close() {
    if (open) gps_close(&data);
    open = false;
  }
  /// 0 or an errno.
  int connect(const GpsParams& params) {
    data = {};
    if (gps_open(params.host.c_str(), params.port.c_str(), &data) != 0) return ECONNREFUSED;
    open = true;
    return gps_stream(&data, WATCH_ENABLE | WATCH_JSON, nullptr) == 0 ? 0 : ECONNRESET;
  }
};

GpsdClient::GpsdClient(const GpsParams& params, SampleSink& sink)
    : params_(params),
      sink_(sink),
      reporter_(Source::gps, sink),
      backoff_(params.reopen),
      connection_(std::make_unique<Connection>()) {}

GpsdClient::~GpsdClient() = default;

void GpsdClient::service(Time timeout, int stop_fd) {
  if (!connection_->open) return connect(timeout, stop_fd);
  std::array<pollfd, 1> fds{{{.fd = connection_->data.gps_fd, .events = POLLIN | POLLRDHUP, .revents = 0}}};
  if (!wait_for(fds, timeout, stop_fd)) return;
  const Time now = monotonic_now();
  if (fds[0].revents != 0) drain(now);
  // A line that was cut off by the end would keep libgps waiting for its rest.
  if (connection_->open && (fds[0].revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0) fail(now, ECONNRESET);
  if (connection_->open && now - last_fix_ >= from_seconds(params_.silence_s)) reporter_.stale(now);
}

void GpsdClient::connect(Time timeout, int stop_fd) {
  const Time wait = backoff_.remaining(monotonic_now());
  if (!pause_for(std::min(timeout, wait), stop_fd) || wait > timeout) return;
  if (const int code = connection_->connect(params_); code != 0) return fail(monotonic_now(), code);
  last_fix_ = monotonic_now();
}

// One read takes one line; libgps keeps the others that came with it.
void GpsdClient::drain(Time now) {
  constexpr int kMostLines = 64;
  for (int i = 0; i < kMostLines; ++i) {
    const int bytes = gps_read(&connection_->data, nullptr, 0);
    if (bytes < 0) return fail(now, ECONNRESET);
    if (bytes > 0 && has_position(connection_->data)) deliver(now);
    if (!gps_waiting(&connection_->data, 0)) return;
  }
}

void GpsdClient::deliver(Time now) {
  const gps_fix_t& fix = connection_->data.fix;
  last_fix_ = now;
  backoff_.succeeded();
  reporter_.fresh(now);
  sink_.on_fix({.stamp = now,
                .latitude_deg = fix.latitude,
                .longitude_deg = fix.longitude,
                .altitude_m = fix.mode == MODE_3D && std::isfinite(fix.altHAE) ? fix.altHAE : 0.0,
                .horizontal_sigma_m = horizontal_sigma(fix)});
}

void GpsdClient::fail(Time now, int error_code) {
  connection_->close();
  backoff_.failed(now);
  reporter_.failed(now, error_code);
}

}  // namespace hindsight
