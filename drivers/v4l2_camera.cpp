// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/v4l2_camera.h"

#include <linux/videodev2.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "config/exit_code.h"
#include "drivers/monotonic_clock.h"
#include "drivers/wait.h"

namespace hindsight {
namespace {

// A kernel stamp older than this when its frame is read is not a time of arrival.
constexpr Time kOldestStamp = std::chrono::seconds(10);

/// `height` rows, without the padding at their ends.
void copy_rows(std::span<const std::uint8_t> in, std::size_t stride, std::size_t row, int height,
               std::vector<std::uint8_t>& out) {
  out.clear();
  for (std::size_t i = 0; i < static_cast<std::size_t>(height); ++i) {
    const auto begin = in.subspan(i * stride, row);
    out.insert(out.end(), begin.begin(), begin.end());
  }
}

}  // namespace

std::size_t frame_bytes(const CameraFormatParams& params) {
  // A JPEG longer than two bytes a pixel has no use.
  const std::size_t row =
      row_bytes(params) != 0 ? row_bytes(params) : static_cast<std::size_t>(params.width_px) * 2;
  return row * static_cast<std::size_t>(params.height_px);
}

V4l2Camera::V4l2Camera(const CameraParams& params, FramePool& pool, SampleSink& sink)
    : params_(params), pool_(pool), sink_(sink), reporter_(Source::camera, sink), backoff_(params.reopen) {
  DeviceError error;
  if (!open(error)) throw FatalError(kExitNoDevice, error.message);
}

bool V4l2Camera::open(DeviceError& error) {
  stream_ = V4l2Stream::open(params_.format, error);
  if (!stream_) return false;
  const std::size_t row = row_bytes(params_.format);
  const std::size_t rows_before_last = static_cast<std::size_t>(params_.format.height_px) - 1;
  if (row == 0)
    screen_ = FrameScreen(1, frame_bytes(params_.format));
  else
    screen_ = FrameScreen(stream_->stride_bytes() * rows_before_last + row, stream_->image_bytes());
  last_good_ = monotonic_now();
  controls_read_ = Time{};
  return true;
}

void V4l2Camera::service(Time timeout, int stop_fd) {
  if (!stream_) return reopen(timeout, stop_fd);
  std::array<pollfd, 1> fds{{{.fd = stream_->fd(), .events = POLLIN, .revents = 0}}};
  if (!wait_for(fds, std::min(timeout, until_judged(monotonic_now())), stop_fd)) return;
  if (fds[0].revents != 0) drain();
  const Time now = monotonic_now();
  if (stream_) judge_silence(now);
  reporter_.set_dropped(statistics_.dropped());
  reporter_.flush(now);
}

void V4l2Camera::reopen(Time timeout, int stop_fd) {
  const Time wait = backoff_.remaining(monotonic_now());
  if (!pause_for(std::min(timeout, wait), stop_fd) || wait > timeout) return;
  DeviceError error;
  if (!open(error)) return fail(monotonic_now(), error.code);
  ++statistics_.reopened;
}

// Empties the queue and delivers the newest good frame. Bounded: a camera cannot be faster than its buffers.
void V4l2Camera::drain() {
  std::optional<FilledBuffer> newest;
  int code = 0;
  for (int i = 0; i < params_.format.buffers && code == 0; ++i) {
    FilledBuffer buffer;
    code = stream_->dequeue(buffer);
    if (code != 0) break;
    const bool error_flag = (buffer.flags & V4L2_BUF_FLAG_ERROR) != 0;
    if (!screen_.judge(buffer.sequence, error_flag, buffer.bytes.size(), statistics_.frames)) {
      code = stream_->give_back(buffer);
      continue;
    }
    if (newest) {
      ++statistics_.outdated;
      code = stream_->give_back(*newest);
    }
    newest = buffer;
  }
  if (newest) {
    deliver(*newest);
    if (code == 0 || code == EAGAIN) code = stream_->give_back(*newest);
  } else if (code == EAGAIN && hung_up()) {
    code = ENODEV;
  }
  if (code != 0 && code != EAGAIN) fail(monotonic_now(), code);
}

// Whether poll(2) woke us for good: without this a dead device that has no frame would wake us again and
// again.
bool V4l2Camera::hung_up() const {
  pollfd fd{.fd = stream_->fd(), .events = POLLIN, .revents = 0};
  return ::poll(&fd, 1, 0) > 0 && (fd.revents & (POLLERR | POLLHUP | POLLNVAL)) != 0;
}

void V4l2Camera::deliver(const FilledBuffer& buffer) {
  FrameRef slot = pool_.take();
  if (!slot) {
    ++statistics_.no_slot;
    return;
  }
  const Time now = monotonic_now();
  refresh_controls(now);
  Frame& frame = slot.writable();
  const std::size_t row = row_bytes(params_.format);
  if (row == 0)
    frame.bytes.assign(buffer.bytes.begin(), buffer.bytes.end());
  else
    copy_rows(buffer.bytes, stream_->stride_bytes(), row, params_.format.height_px, frame.bytes);
  const bool stamp_holds = buffer.stamp > std::max(now - kOldestStamp, Time{}) && buffer.stamp <= now;
  frame.stamp = stamp_holds ? buffer.stamp : now;
  frame.sequence = buffer.sequence;
  frame.format = pixel_format(params_.format.format);
  frame.width_px = params_.format.width_px;
  frame.height_px = params_.format.height_px;
  frame.exposure_s = exposure_s_;
  frame.gain = gain_;
  if (decode_frame(frame) != DecodeResult::ok) {
    ++statistics_.undecodable;
    return;
  }
  ++statistics_.delivered;
  last_good_ = now;
  backoff_.succeeded();
  reporter_.fresh(now);
  sink_.on_frame(std::move(slot));
}

void V4l2Camera::refresh_controls(Time now) {
  if (now - controls_read_ < from_seconds(params_.controls_period_s)) return;
  controls_read_ = now;
  stream_->read_controls(exposure_s_, gain_);
}

Time V4l2Camera::until_judged(Time now) const {
  const bool stalled = now - last_good_ >= from_seconds(params_.stall_s);
  return last_good_ + from_seconds(stalled ? params_.restart_s : params_.stall_s) - now;
}

void V4l2Camera::judge_silence(Time now) {
  const Time silent = now - last_good_;
  if (silent >= from_seconds(params_.restart_s)) return fail(now, ETIMEDOUT);
  if (silent >= from_seconds(params_.stall_s)) reporter_.stale(now);
}

void V4l2Camera::fail(Time now, int error_code) {
  stream_.reset();
  backoff_.failed(now);
  reporter_.failed(now, error_code);
}

}  // namespace hindsight
