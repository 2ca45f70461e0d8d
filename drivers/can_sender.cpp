// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/can_sender.h"

#include <linux/can.h>
#include <sys/socket.h>

#include <algorithm>

#include "config/exit_code.h"

namespace hindsight {

CanSender::CanSender(const std::string& interface, const BackoffParams& reopen)
    : interface_(interface), backoff_(reopen) {
  DeviceError error;
  socket_ = open_can_sender(interface_, error);
  if (!socket_) throw FatalError(kExitNoDevice, error.message);
}

int CanSender::send(const CanFrame& frame, Time now) {
  if (!socket_) {
    if (const int code = reopen(now); code != 0) {
      ++counts_.failed;
      return code;
    }
  }
  can_frame out{};
  out.can_id = frame.id;
  out.len = std::min<std::uint8_t>(frame.length, CAN_MAX_DLEN);
  std::copy(frame.data.begin(), frame.data.end(), out.data);
  if (::send(socket_.get(), &out, sizeof(out), MSG_DONTWAIT | MSG_NOSIGNAL) == sizeof(out)) {
    ++counts_.sent;
    backoff_.succeeded();
    return 0;
  }
  const int code = errno;
  if (code == ENOBUFS || code == EAGAIN) {
    ++counts_.queue_full;
    return code;
  }
  ++counts_.failed;
  if (code != ENETDOWN) {  // down is not gone: the socket works again once the interface is up
    socket_.reset();
    backoff_.failed(now);
  }
  return code;
}

int CanSender::reopen(Time now) {
  if (backoff_.remaining(now) > Time{}) return ENODEV;
  DeviceError error;
  socket_ = open_can_sender(interface_, error);
  if (!socket_) backoff_.failed(now);
  return socket_ ? 0 : error.code;
}

}  // namespace hindsight
