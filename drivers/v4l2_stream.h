// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "config/params.h"
#include "drivers/device_error.h"
#include "drivers/samples.h"
#include "drivers/unique_fd.h"

namespace hindsight {

/// What is asked of the camera. A camera that gives another size or format is refused.
struct CameraFormatParams {
  std::string device = "/dev/video0";
  int width_px = 720;
  int height_px = 480;
  std::string format = "yuyv";
  double rate_hz = 10.0;
  int buffers = 4;

  void visit(auto&& param) {
    param("device", device, AnyText{}, "video device");
    param("width_px", width_px, Range{16, 4096}, "width of the picture [px]");
    param("height_px", height_px, Range{16, 4096}, "height of the picture [px]");
    param("format", format, Choices{"yuyv", "mjpeg", "bgr24"}, "how the camera sends its pictures");
    param("rate_hz", rate_hz, Range{0.5, 240.0},
          "pictures a second to ask for; the camera may give others [Hz]");
    param("buffers", buffers, Range{2, 32}, "kernel buffers to stream through");
  }
};

/// "yuyv", "mjpeg" or "bgr24", as CameraFormatParams::format has it.
PixelFormat pixel_format(const std::string& name);

/// The kernel's code of the same, V4L2_PIX_FMT_*.
std::uint32_t fourcc_of(PixelFormat format);

/// Bytes of one row of pixels, without padding; 0 for MJPEG.
std::size_t row_bytes(const CameraFormatParams& params);

/// A buffer that the kernel has filled; its bytes stand until it is given back.
struct FilledBuffer {
  std::uint32_t index = 0;
  std::uint32_t sequence = 0;
  std::uint32_t flags = 0;  ///< V4L2_BUF_FLAG_*
  Time stamp{};             ///< the kernel's; zero where that is not of the monotonic clock
  std::span<const std::uint8_t> bytes;
};

/// A video device that is open and streaming: descriptor, mapped buffers and all. Closing is destruction.
class V4l2Stream {
 public:
  /// Opens, sets format and rate, maps the buffers and starts the stream. Null on failure, with `error`
  /// filled in.
  static std::unique_ptr<V4l2Stream> open(const CameraFormatParams& params, DeviceError& error);
  ~V4l2Stream();
  V4l2Stream(const V4l2Stream&) = delete;
  V4l2Stream& operator=(const V4l2Stream&) = delete;

  int fd() const { return fd_.get(); }
  /// Bytes from one row to the next (at least the row itself); meaningless for MJPEG.
  std::size_t stride_bytes() const { return stride_bytes_; }

  /// The most bytes that a picture takes.
  std::size_t image_bytes() const { return image_bytes_; }

  /// Takes the oldest filled buffer. 0, EAGAIN where there is none, or the errno of a failure.
  int dequeue(FilledBuffer& buffer);
  /// Gives a buffer back. 0 or an errno.
  int give_back(const FilledBuffer& buffer);
  /// Exposure time and gain as the camera tells them now; left alone where it does not. Gain is in the
  /// driver's units.
  void read_controls(float& exposure_s, float& gain);

 private:
  struct Mapping {
    void* start = nullptr;
    std::size_t length = 0;
  };

  V4l2Stream(UniqueFd fd, std::string device) : fd_(std::move(fd)), device_(std::move(device)) {}
  bool check_capabilities(DeviceError& error);
  bool set_format(const CameraFormatParams& params, DeviceError& error);
  void ask_for_rate(double rate_hz);
  bool map_buffers(int count, DeviceError& error);
  bool start(DeviceError& error);
  bool has_control(std::uint32_t id);

  UniqueFd fd_;
  std::string device_;
  std::size_t stride_bytes_ = 0;
  std::size_t image_bytes_ = 0;
  std::vector<Mapping> mappings_;
  bool tells_exposure_ = false;
  std::uint32_t gain_control_ = 0;  // 0: none
};

}  // namespace hindsight
