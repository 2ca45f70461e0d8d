// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "drivers/backoff.h"
#include "drivers/can_socket.h"
#include "drivers/samples.h"

namespace hindsight {

/// What became of the frames to send since start.
struct SendCounts {
  std::uint32_t sent = 0;
  std::uint32_t queue_full = 0;  ///< ENOBUFS or EAGAIN: the bus does not take them
  std::uint32_t failed = 0;      ///< interface down or away
};

/// Sends on a CAN bus, on a socket of its own (a failure is told once to each socket, so reader and writer
/// must not share one). Never blocks and never keeps a frame for later: what does not go out now is dropped
/// and counted, and the next call brings a newer one. After ENODEV or ENXIO the socket is opened anew, with
/// growing pauses. One thread at a time; no allocation except in an opening.
class CanSender {
 public:
  /// Throws FatalError(kExitNoDevice) where the interface is absent or down.
  CanSender(const std::string& interface, const BackoffParams& reopen);

  /// 0, or the errno. `now` paces the reopening only.
  int send(const CanFrame& frame, Time now);

  const SendCounts& counts() const { return counts_; }

 private:
  int reopen(Time now);

  std::string interface_;
  Backoff backoff_;
  UniqueFd socket_;
  SendCounts counts_;
};

}  // namespace hindsight
