// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <string>

#include "daemon/outbox.h"
#include "daemon/robot_config.h"
#include "drivers/samples.h"

namespace hindsight {

/// Sends messages over LCM, and camera previews where they are wanted. Only ever publishes: a process that subscribes
/// with liblcm can be crashed by one packet. Without a network it goes on trying now and then. One thread.
class Publisher {
 public:
  explicit Publisher(const TelemetryParams& params);
  ~Publisher();
  Publisher(const Publisher&) = delete;
  Publisher& operator=(const Publisher&) = delete;

  void publish(const Outbox& outbox, const FrameRef& frame, Time now, std::int64_t utime_us);

 private:
  struct Preview;

  bool connect(Time now);
  void publish_preview(const Frame& frame, std::int64_t utime_us);
  void send(const std::string& channel, std::span<const std::uint8_t> bytes);

  TelemetryParams params_;
  void* lcm_ = nullptr;  ///< lcm_t
  Time next_try_{};
  Time next_preview_{};
  std::unique_ptr<Preview> preview_;
};

}  // namespace hindsight
