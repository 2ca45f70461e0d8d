// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/socketcan_bus.h"

#include <linux/can.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "config/exit_code.h"
#include "drivers/can_stamp.h"
#include "drivers/monotonic_clock.h"
#include "drivers/wait.h"

namespace hindsight {
namespace {

constexpr int kBatch = 32;
constexpr std::size_t kControlBytes = CMSG_SPACE(sizeof(timespec)) + CMSG_SPACE(sizeof(std::uint32_t));

Time wall_now() { return std::chrono::system_clock::now().time_since_epoch(); }

/// What comes beside a frame.
struct Ancillary {
  Time wall_stamp{};
  bool has_stamp = false;
  std::uint32_t overflow = 0;
  bool has_overflow = false;
};

Ancillary read_ancillary(msghdr& header) {
  Ancillary found;
  for (cmsghdr* part = CMSG_FIRSTHDR(&header); part != nullptr; part = CMSG_NXTHDR(&header, part)) {
    if (part->cmsg_level != SOL_SOCKET) continue;
    if (part->cmsg_type == SO_TIMESTAMPNS) {
      timespec stamp{};
      std::memcpy(&stamp, CMSG_DATA(part), sizeof(stamp));
      found.wall_stamp = std::chrono::seconds(stamp.tv_sec) + std::chrono::nanoseconds(stamp.tv_nsec);
      found.has_stamp = true;
    } else if (part->cmsg_type == SO_RXQ_OVFL) {
      std::memcpy(&found.overflow, CMSG_DATA(part), sizeof(found.overflow));
      found.has_overflow = true;
    }
  }
  return found;
}

}  // namespace

struct SocketCanBus::Batch {
  std::array<can_frame, kBatch> frames;
  std::array<iovec, kBatch> vectors;
  struct alignas(cmsghdr) Control {
    std::array<unsigned char, kControlBytes> bytes;
  };
  std::array<Control, kBatch> controls;
  std::array<mmsghdr, kBatch> headers;

  /// recvmmsg(2) overwrites the lengths, so that they are set anew before each call.
  void prepare() {
    for (std::size_t i = 0; i < kBatch; ++i) {
      vectors[i] = {.iov_base = &frames[i], .iov_len = sizeof(can_frame)};
      headers[i] = {};
      headers[i].msg_hdr.msg_iov = &vectors[i];
      headers[i].msg_hdr.msg_iovlen = 1;
      headers[i].msg_hdr.msg_control = controls[i].bytes.data();
      headers[i].msg_hdr.msg_controllen = kControlBytes;
    }
  }
};

SocketCanBus::SocketCanBus(const CanBusParams& params, std::vector<std::uint32_t> ids, SampleSink& sink)
    : params_(params),
      ids_(std::move(ids)),
      sink_(sink),
      reporter_(Source::can, sink),
      backoff_(params.reopen),
      batch_(std::make_unique<Batch>()) {
  DeviceError error;
  if (!open(error)) throw FatalError(kExitNoDevice, error.message);
}

SocketCanBus::~SocketCanBus() = default;

bool SocketCanBus::open(DeviceError& error) {
  socket_ = open_can_receiver(params_.interface, ids_, error);
  last_empty_ = monotonic_now();
  overflow_ = 0;
  return static_cast<bool>(socket_);
}

void SocketCanBus::service(Time timeout, int stop_fd) {
  if (!socket_) return reopen(timeout, stop_fd);
  std::array<pollfd, 1> fds{{{.fd = socket_.get(), .events = POLLIN, .revents = 0}}};
  if (!wait_for(fds, timeout, stop_fd)) return;
  const Time woken = monotonic_now();
  if (fds[0].revents != 0)
    drain();
  else
    last_empty_ = woken;
  reporter_.set_dropped(dropped_);
  reporter_.flush(monotonic_now());
}

void SocketCanBus::reopen(Time timeout, int stop_fd) {
  const Time wait = backoff_.remaining(monotonic_now());
  if (!pause_for(std::min(timeout, wait), stop_fd) || wait > timeout) return;
  DeviceError error;
  if (!open(error)) fail(monotonic_now(), error.code);
}

void SocketCanBus::drain() {
  for (int taken = 0; taken < params_.most_frames_per_service;) {
    batch_->prepare();
    const Time before = monotonic_now();
    const int count = ::recvmmsg(socket_.get(), batch_->headers.data(), kBatch, MSG_DONTWAIT, nullptr);
    const int code = count < 0 ? errno : 0;
    const Time now = monotonic_now();
    const Time wall = wall_now();
    for (int i = 0; i < count; ++i) deliver(static_cast<std::size_t>(i), now, wall);
    if (code != 0 && code != EAGAIN && code != EINTR) return fail(now, code);
    if (count < kBatch) {
      last_empty_ = before;
      return;
    }
    taken += count;
  }
}

void SocketCanBus::deliver(std::size_t index, Time now, Time wall) {
  if (batch_->headers[index].msg_len != sizeof(can_frame)) return;  // none but classic frames are asked for
  const can_frame& in = batch_->frames[index];
  const Ancillary ancillary = read_ancillary(batch_->headers[index].msg_hdr);
  if (ancillary.has_overflow) dropped_ += ancillary.overflow - std::exchange(overflow_, ancillary.overflow);
  CanFrame frame;
  frame.stamp = ancillary.has_stamp ? monotonic_stamp(ancillary.wall_stamp, wall, now, last_empty_) : now;
  frame.id = in.can_id;
  frame.length = std::min<std::uint8_t>(in.len, CAN_MAX_DLEN);
  std::copy_n(in.data, frame.length, frame.data.begin());
  backoff_.succeeded();
  reporter_.fresh(now);
  sink_.on_can(frame);
}

void SocketCanBus::fail(Time now, int error_code) {
  socket_.reset();
  backoff_.failed(now);
  reporter_.failed(now, error_code);
}

}  // namespace hindsight
