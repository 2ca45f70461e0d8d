// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

#include "drivers/backoff.h"
#include "drivers/frame_decoder.h"
#include "drivers/frame_pool.h"
#include "drivers/frame_screen.h"
#include "drivers/source_reporter.h"
#include "drivers/v4l2_stream.h"

namespace hindsight {

struct CameraParams {
  CameraFormatParams format;
  double stall_s = 0.25;
  double restart_s = 3.0;
  double controls_period_s = 1.0;
  BackoffParams reopen;

  void visit(auto&& param) {
    format.visit(param);
    param("stall_s", stall_s, Range{0.02, 60.0}, "without a good frame for so long the camera is stale [s]");
    param("restart_s", restart_s, Range{0.1, 600.0}, "without one for so long it is opened anew [s]");
    param("controls_period_s", controls_period_s, Range{0.0, 600.0},
          "how often exposure and gain are read [s]");
    reopen.visit(param);
  }
};

/// What became of the frames since start.
struct CameraStatistics {
  std::uint32_t delivered = 0;
  FrameCounts frames;
  std::uint32_t outdated = 0;     ///< a newer frame was already waiting
  std::uint32_t undecodable = 0;  ///< corrupt or of another size, by the decoder
  std::uint32_t no_slot = 0;      ///< the pool was empty: the consumer holds too many
  std::uint32_t reopened = 0;

  std::uint32_t dropped() const {
    return frames.missed + frames.broken + frames.wrong_length + outdated + undecodable + no_slot;
  }
};

/// A camera: newest frame first, decoded, with the kernel's time stamp.
///
/// A service that finds several frames waiting delivers the newest and drops the others (counted). Frames
/// that the kernel marks as broken, of the wrong length, or that do not decode are dropped and counted, as
/// are gaps in the sequence numbers. Reports: fresh with the first frame after an opening, stale after
/// `stall_s` without one, failed when the device is gone or has been silent for `restart_s`; then it is
/// opened from scratch, with growing pauses.
class V4l2Camera {
 public:
  /// Opens the camera. Throws FatalError(kExitNoDevice) that names the device and the reason: absent, busy,
  /// not a camera, or another size or format than asked for. `pool`'s slots must have room for the format
  /// (frame_bytes()).
  V4l2Camera(const CameraParams& params, FramePool& pool, SampleSink& sink);

  /// Waits up to `timeout` for a frame and delivers it; also judges the stall timer and reopens. Returns
  /// early when `stop_fd` (an eventfd, or -1) is readable. Never throws. One thread at a time.
  void service(Time timeout, int stop_fd = -1);

  const CameraStatistics& statistics() const { return statistics_; }

 private:
  bool open(DeviceError& error);
  void reopen(Time timeout, int stop_fd);
  void drain();
  bool hung_up() const;
  void deliver(const FilledBuffer& buffer);
  void refresh_controls(Time now);
  Time until_judged(Time now) const;
  void judge_silence(Time now);
  void fail(Time now, int error_code);

  CameraParams params_;
  FramePool& pool_;
  SampleSink& sink_;
  SourceReporter reporter_;
  Backoff backoff_;
  FrameScreen screen_{0, 0};
  CameraStatistics statistics_;
  std::unique_ptr<V4l2Stream> stream_;  // empty while the camera is gone
  Time last_good_{};                    // arrival of the last good frame, or the opening
  Time controls_read_{};
  float exposure_s_ = 0.0F;
  float gain_ = 0.0F;
};

/// The most bytes that a raw frame of this format takes: what FramePool must reserve.
std::size_t frame_bytes(const CameraFormatParams& params);

}  // namespace hindsight
