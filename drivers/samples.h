// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What sensors say: the one header that live drivers, replay, simulation and the core share. A sample is raw,
// as it came off the device, with the time at which it did. Plain data: no driver, no thread, no library
// type.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <utility>
#include <vector>

namespace hindsight {

/// Time since the epoch of the monotonic clock. A log keeps the values of the run that it recorded.
using Time = std::chrono::nanoseconds;

constexpr double to_seconds(Time t) { return std::chrono::duration<double>(t).count(); }
constexpr Time from_seconds(double s) {
  return std::chrono::duration_cast<Time>(std::chrono::duration<double>(s));
}

enum class PixelFormat : std::uint8_t { yuyv = 0, mjpeg = 1, bgr24 = 2 };

/// One camera frame. `bytes` are the camera's own, compressed frames stay compressed; `bgr` is the same
/// picture decoded (drivers/frame_decoder.h), rows without padding, 3 bytes a pixel, width_px * height_px * 3
/// in all.
struct Frame {
  Time stamp{};
  std::uint32_t sequence = 0;  ///< the driver's frame counter; a gap means lost frames
  PixelFormat format = PixelFormat::yuyv;
  int width_px = 0;
  int height_px = 0;
  float exposure_s = 0.0F;  ///< 0 where the camera does not tell
  float gain = 0.0F;        ///< 0 where the camera does not tell
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint8_t> bgr;
};

/// Shared, counted reference to a Frame that lives in a FramePool (drivers/frame_pool.h). Copying it never
/// allocates; the slot goes back to its pool with the last reference. Thread-safe as std::shared_ptr is.
struct FrameSlot {
  Frame frame;
  std::atomic<int> references{0};
};
class FrameRef {
 public:
  FrameRef() = default;
  explicit FrameRef(FrameSlot* slot) : slot_(slot) { acquire(); }
  FrameRef(const FrameRef& other) : slot_(other.slot_) { acquire(); }
  FrameRef(FrameRef&& other) noexcept : slot_(std::exchange(other.slot_, nullptr)) {}
  FrameRef& operator=(FrameRef other) noexcept {
    std::swap(slot_, other.slot_);
    return *this;
  }
  ~FrameRef() {
    if (slot_ != nullptr) slot_->references.fetch_sub(1, std::memory_order_acq_rel);
  }
  explicit operator bool() const { return slot_ != nullptr; }
  const Frame& operator*() const { return slot_->frame; }
  const Frame* operator->() const { return &slot_->frame; }
  /// For the producer that fills the slot before it hands out the first copy.
  Frame& writable() { return slot_->frame; }

 private:
  void acquire() {
    if (slot_ != nullptr) slot_->references.fetch_add(1, std::memory_order_relaxed);
  }
  FrameSlot* slot_ = nullptr;
};

/// One frame of the CAN bus, as received. `id` holds the kernel's flags too (CAN_ERR_FLAG and so on).
struct CanFrame {
  Time stamp{};
  std::uint32_t id = 0;
  std::uint8_t length = 0;
  std::array<std::uint8_t, 8> data{};
};

enum class Line : std::uint8_t { bumper_left = 0, bumper_right = 1, estop = 2 };
constexpr int kLineCount = 3;

/// A digital input changed (or reports its level at start). `active` is logical: true is "pressed".
struct LineEdge {
  Time stamp{};
  Line line = Line::bumper_left;
  bool active = false;
};

/// A GPS fix, WGS84.
struct GpsFix {
  Time stamp{};
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double altitude_m = 0.0;
  double horizontal_sigma_m = 0.0;  ///< one standard deviation; 0 where the receiver does not tell
};

enum class CommandKind : std::uint8_t {
  go_to_local = 0,   ///< a, b: east, north [m] in W
  go_to_global = 1,  ///< a, b: latitude, longitude [deg]
  stop = 2,
  arm = 3,
  disarm = 4,
  release_estop = 5,
  set_mode = 6,  ///< a: the mode's number (daemon/mode.h)
  save_model = 7
};

/// What the operator asked for, after the receiver has checked it.
struct OperatorCommand {
  Time stamp{};
  CommandKind kind = CommandKind::stop;
  double a = 0.0;
  double b = 0.0;
  std::int64_t sequence = 0;
};

/// What a source last said of itself.
enum class SourceState : std::uint8_t { never_seen = 0, fresh = 1, stale = 2, failed = 3, absent = 4 };
enum class Source : std::uint8_t { camera = 0, can = 1, gpio = 2, gps = 3, operator_link = 4 };
constexpr int kSourceCount = 5;

/// A source's own report: a device that opened, failed, dropped. Not periodic.
struct SourceReport {
  Time stamp{};
  Source source = Source::camera;
  SourceState state = SourceState::never_seen;
  std::uint32_t dropped = 0;    ///< samples lost since start: gaps, overflows, corrupt frames
  std::int32_t error_code = 0;  ///< errno of the last failure, 0 if none
};

}  // namespace hindsight
