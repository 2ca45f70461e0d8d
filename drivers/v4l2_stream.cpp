// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "drivers/v4l2_stream.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hindsight {
namespace {

constexpr v4l2_buf_type kType = V4L2_BUF_TYPE_VIDEO_CAPTURE;

/// ioctl(2), begun again when a signal interrupts it. 0 or the errno.
int control(int fd, unsigned long request, void* argument) {
  int result = 0;
  do {
    result = ::ioctl(fd, request, argument);
  } while (result < 0 && errno == EINTR);
  return result < 0 ? errno : 0;
}

std::string fourcc_text(std::uint32_t code) {
  std::string text;
  for (unsigned shift = 0; shift < 32; shift += 8) {
    const char c = static_cast<char>((code >> shift) & 0x7FU);
    text += c >= ' ' && c < 0x7F ? c : '?';
  }
  return text;
}

std::string describe(const v4l2_pix_format& pix) {
  return fmt::format("{} x {} {}", pix.width, pix.height, fourcc_text(pix.pixelformat));
}

std::size_t bytes_per_pixel(PixelFormat format) { return format == PixelFormat::bgr24 ? 3 : 2; }

v4l2_buffer plain_buffer(std::uint32_t index) {
  v4l2_buffer buffer{};
  buffer.type = kType;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = index;
  return buffer;
}

Time monotonic_stamp_of(const v4l2_buffer& buffer) {
  if ((buffer.flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) != V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC) return Time{};
  return std::chrono::seconds(buffer.timestamp.tv_sec) + std::chrono::microseconds(buffer.timestamp.tv_usec);
}

}  // namespace

std::uint32_t fourcc_of(PixelFormat format) {
  switch (format) {
    case PixelFormat::yuyv:
      return V4L2_PIX_FMT_YUYV;
    case PixelFormat::mjpeg:
      return V4L2_PIX_FMT_MJPEG;
    case PixelFormat::bgr24:
      break;
  }
  return V4L2_PIX_FMT_BGR24;
}

PixelFormat pixel_format(const std::string& name) {
  if (name == "mjpeg") return PixelFormat::mjpeg;
  return name == "bgr24" ? PixelFormat::bgr24 : PixelFormat::yuyv;
}

std::size_t row_bytes(const CameraFormatParams& params) {
  const PixelFormat format = pixel_format(params.format);
  return format == PixelFormat::mjpeg ? 0
                                      : static_cast<std::size_t>(params.width_px) * bytes_per_pixel(format);
}

std::unique_ptr<V4l2Stream> V4l2Stream::open(const CameraFormatParams& params, DeviceError& error) {
  UniqueFd fd(::open(params.device.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
  if (!fd) {
    error = DeviceError::from_errno(errno, params.device, "cannot be opened");
    return nullptr;
  }
  std::unique_ptr<V4l2Stream> stream(new V4l2Stream(std::move(fd), params.device));
  if (!stream->check_capabilities(error) || !stream->set_format(params, error)) return nullptr;
  stream->ask_for_rate(params.rate_hz);
  if (!stream->map_buffers(params.buffers, error) || !stream->start(error)) return nullptr;
  stream->tells_exposure_ = stream->has_control(V4L2_CID_EXPOSURE_ABSOLUTE);
  for (const std::uint32_t id : std::array<std::uint32_t, 2>{V4L2_CID_GAIN, V4L2_CID_ANALOGUE_GAIN}) {
    if (stream->gain_control_ == 0 && stream->has_control(id)) stream->gain_control_ = id;
  }
  return stream;
}

V4l2Stream::~V4l2Stream() {
  int type = kType;
  control(fd_.get(), VIDIOC_STREAMOFF, &type);
  for (const Mapping& mapping : mappings_) ::munmap(mapping.start, mapping.length);
}

bool V4l2Stream::check_capabilities(DeviceError& error) {
  v4l2_capability capability{};
  if (const int code = control(fd_.get(), VIDIOC_QUERYCAP, &capability); code != 0) {
    error = DeviceError::from_errno(code, device_, "is not a video device");
    return false;
  }
  constexpr std::uint32_t kNeeded = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
  if ((capability.device_caps & kNeeded) == kNeeded) return true;
  error = {ENODEV, device_ + ": does not capture video by streaming"};
  return false;
}

bool V4l2Stream::set_format(const CameraFormatParams& params, DeviceError& error) {
  const PixelFormat format = pixel_format(params.format);
  v4l2_format wanted{};
  wanted.type = kType;
  wanted.fmt.pix.width = static_cast<std::uint32_t>(params.width_px);
  wanted.fmt.pix.height = static_cast<std::uint32_t>(params.height_px);
  wanted.fmt.pix.pixelformat = fourcc_of(format);
  wanted.fmt.pix.field = V4L2_FIELD_NONE;
  v4l2_format given = wanted;
  if (const int code = control(fd_.get(), VIDIOC_S_FMT, &given); code != 0) {
    error = DeviceError::from_errno(code, device_, "refuses " + describe(wanted.fmt.pix));
    return false;
  }
  if (given.fmt.pix.width != wanted.fmt.pix.width || given.fmt.pix.height != wanted.fmt.pix.height ||
      given.fmt.pix.pixelformat != wanted.fmt.pix.pixelformat) {
    error = {EINVAL, fmt::format("{}: asked for {}, the camera gives {}", device_, describe(wanted.fmt.pix),
                                 describe(given.fmt.pix))};
    return false;
  }
  stride_bytes_ = std::max<std::size_t>(row_bytes(params), given.fmt.pix.bytesperline);
  image_bytes_ = given.fmt.pix.sizeimage;
  return true;
}

void V4l2Stream::ask_for_rate(double rate_hz) {
  v4l2_streamparm parameters{};
  parameters.type = kType;
  parameters.parm.capture.timeperframe = {
      .numerator = 1000, .denominator = static_cast<std::uint32_t>(std::lround(rate_hz * 1000.0))};
  control(fd_.get(), VIDIOC_S_PARM, &parameters);  // many cameras know one rate only: no failure
}

bool V4l2Stream::map_buffers(int count, DeviceError& error) {
  v4l2_requestbuffers request{};
  request.count = static_cast<std::uint32_t>(count);
  request.type = kType;
  request.memory = V4L2_MEMORY_MMAP;
  if (const int code = control(fd_.get(), VIDIOC_REQBUFS, &request); code != 0) {
    error =
        DeviceError::from_errno(code, device_, "gives no buffers");  // EBUSY: another program streams from it
    return false;
  }
  for (std::uint32_t i = 0; i < request.count; ++i) {
    v4l2_buffer buffer = plain_buffer(i);
    int code = control(fd_.get(), VIDIOC_QUERYBUF, &buffer);
    void* start = MAP_FAILED;
    if (code == 0) {
      start = ::mmap(nullptr, buffer.length, PROT_READ | PROT_WRITE, MAP_SHARED, fd_.get(), buffer.m.offset);
      if (start == MAP_FAILED) code = errno;
    }
    if (code != 0) {
      error = DeviceError::from_errno(code, device_, "a buffer cannot be mapped");
      return false;
    }
    mappings_.push_back({start, buffer.length});
  }
  return true;
}

bool V4l2Stream::start(DeviceError& error) {
  int code = 0;
  for (std::uint32_t i = 0; i < mappings_.size() && code == 0; ++i) {
    v4l2_buffer buffer = plain_buffer(i);
    code = control(fd_.get(), VIDIOC_QBUF, &buffer);
  }
  int type = kType;
  if (code == 0) code = control(fd_.get(), VIDIOC_STREAMON, &type);
  if (code != 0) error = DeviceError::from_errno(code, device_, "does not stream");
  return code == 0;
}

int V4l2Stream::dequeue(FilledBuffer& filled) {
  v4l2_buffer buffer = plain_buffer(0);
  if (const int code = control(fd_.get(), VIDIOC_DQBUF, &buffer); code != 0) return code;
  if (buffer.index >= mappings_.size()) return EPROTO;
  const Mapping& mapping = mappings_[buffer.index];
  filled.index = buffer.index;
  filled.sequence = buffer.sequence;
  filled.flags = buffer.flags;
  filled.stamp = monotonic_stamp_of(buffer);
  filled.bytes = {static_cast<const std::uint8_t*>(mapping.start),
                  std::min<std::size_t>(buffer.bytesused, mapping.length)};
  return 0;
}

int V4l2Stream::give_back(const FilledBuffer& filled) {
  v4l2_buffer buffer = plain_buffer(filled.index);
  return control(fd_.get(), VIDIOC_QBUF, &buffer);
}

bool V4l2Stream::has_control(std::uint32_t id) {
  v4l2_queryctrl query{};
  query.id = id;
  return control(fd_.get(), VIDIOC_QUERYCTRL, &query) == 0 && (query.flags & V4L2_CTRL_FLAG_DISABLED) == 0;
}

void V4l2Stream::read_controls(float& exposure_s, float& gain) {
  constexpr float kExposureUnit_s = 100e-6F;
  v4l2_control value{};
  value.id = V4L2_CID_EXPOSURE_ABSOLUTE;
  if (tells_exposure_ && control(fd_.get(), VIDIOC_G_CTRL, &value) == 0) {
    exposure_s = static_cast<float>(value.value) * kExposureUnit_s;
  }
  value.id = gain_control_;
  if (gain_control_ != 0 && control(fd_.get(), VIDIOC_G_CTRL, &value) == 0)
    gain = static_cast<float>(value.value);
}

}  // namespace hindsight
