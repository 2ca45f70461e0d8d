// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drivers/backoff.h"
#include "drivers/can_socket.h"
#include "drivers/source_reporter.h"

namespace hindsight {

struct CanBusParams {
  std::string interface = "can0";
  int most_frames_per_service = 256;
  BackoffParams reopen;

  void visit(auto&& param) {
    param("interface", interface, AnyText{}, "SocketCAN network interface");
    param("most_frames_per_service", most_frames_per_service, Range{1, 4096},
          "frames read in one go; what a babbling node sends beyond is lost in the kernel, and counted");
    reopen.visit(param);
  }
};

/// Receives from a CAN bus: the wanted identifiers and all error frames, each with the kernel's time stamp
/// turned into monotonic time (drivers/can_stamp.h).
///
/// Reports: fresh with the first frame after an opening, failed when the interface goes down or away
/// (ENETDOWN, ENODEV, ENXIO; the socket is then opened anew, with growing pauses), lost frames as the kernel
/// counts them. That nothing comes is not judged here: how old each signal may be is known where the signals
/// are.
class SocketCanBus {
 public:
  /// Opens the socket. Throws FatalError(kExitNoDevice) where the interface is absent or down. `ids` are
  /// SocketCAN identifiers, CAN_EFF_FLAG set on extended ones (VehicleDecoder::received_ids()).
  SocketCanBus(const CanBusParams& params, std::vector<std::uint32_t> ids, SampleSink& sink);
  ~SocketCanBus();

  /// Waits up to `timeout` and delivers what came. Returns early when `stop_fd` (an eventfd, or -1) is
  /// readable. Never throws. One thread at a time.
  void service(Time timeout, int stop_fd = -1);

 private:
  struct Batch;  // buffers of recvmmsg

  bool open(DeviceError& error);
  void reopen(Time timeout, int stop_fd);
  void drain();
  void deliver(std::size_t index, Time now, Time wall);
  void fail(Time now, int error_code);

  CanBusParams params_;
  std::vector<std::uint32_t> ids_;
  SampleSink& sink_;
  SourceReporter reporter_;
  Backoff backoff_;
  UniqueFd socket_;
  std::unique_ptr<Batch> batch_;
  Time last_empty_{};           // no frame in the queue is older
  std::uint32_t overflow_ = 0;  // SO_RXQ_OVFL's last value of this socket
  std::uint32_t dropped_ = 0;   // since start
};

}  // namespace hindsight
