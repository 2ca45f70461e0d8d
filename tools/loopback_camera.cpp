// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/loopback_camera.h"

#include <fcntl.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <opencv2/imgcodecs.hpp>

#include "config/exit_code.h"
#include "drivers/device_error.h"

namespace hindsight::tools {
namespace {

constexpr int kJpegQuality = 90;

std::uint8_t to_byte(double v) { return static_cast<std::uint8_t>(std::clamp(v + 0.5, 0.0, 255.0)); }

/// BT.601, limited range, as cameras mean it. The pair shares the chroma of its left pixel.
void append_yuyv_pair(const std::uint8_t* left, const std::uint8_t* right, std::vector<std::uint8_t>& out) {
  const auto luma = [](const std::uint8_t* p) {
    return to_byte(16.0 + 0.257 * p[2] + 0.504 * p[1] + 0.098 * p[0]);
  };
  out.push_back(luma(left));
  out.push_back(to_byte(128.0 - 0.148 * left[2] - 0.291 * left[1] + 0.439 * left[0]));
  out.push_back(luma(right));
  out.push_back(to_byte(128.0 + 0.439 * left[2] - 0.368 * left[1] - 0.071 * left[0]));
}

[[noreturn]] void fail(ExitCode code, const std::string& device, const std::string& what) {
  throw FatalError(code, DeviceError::from_errno(errno, device, what).message);
}

}  // namespace

LoopbackCamera::LoopbackCamera(const CameraFormatParams& params)
    : params_(params),
      format_(pixel_format(params.format)),
      device_(open(params.device.c_str(), O_WRONLY | O_CLOEXEC)) {
  if (!device_)
    fail(kExitNoDevice, params_.device, "cannot be opened to show pictures to the robot's camera");
  set_format();
}

void LoopbackCamera::set_format() {
  v4l2_format format{};
  format.type = V4L2_BUF_TYPE_VIDEO_OUTPUT;
  v4l2_pix_format& picture = format.fmt.pix;
  picture.width = static_cast<std::uint32_t>(params_.width_px);
  picture.height = static_cast<std::uint32_t>(params_.height_px);
  picture.pixelformat = fourcc_of(format_);
  picture.bytesperline = static_cast<std::uint32_t>(row_bytes(params_));
  const std::uint32_t widest = 3 * picture.width;  // more than a JPEG of this quality takes
  picture.sizeimage = std::max(picture.bytesperline, widest) * picture.height;
  if (format_ != PixelFormat::mjpeg) picture.sizeimage = picture.bytesperline * picture.height;
  picture.field = V4L2_FIELD_NONE;
  picture.colorspace = V4L2_COLORSPACE_SRGB;
  if (ioctl(device_.get(), VIDIOC_S_FMT, &format) != 0)
    fail(kExitNoDevice, params_.device,
         "takes no pictures of this size and format (a v4l2loopback device does)");
}

std::vector<std::uint8_t> LoopbackCamera::encode(std::span<const std::uint8_t> bgr) const {
  std::vector<std::uint8_t> bytes;
  if (format_ == PixelFormat::mjpeg) {
    const cv::Mat picture(params_.height_px, params_.width_px, CV_8UC3,
                          const_cast<std::uint8_t*>(bgr.data()));
    cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  } else if (format_ == PixelFormat::bgr24) {
    bytes.assign(bgr.begin(), bgr.end());
  } else {
    bytes.reserve(bgr.size() / 3 * 2);
    for (std::size_t i = 0; i + 6 <= bgr.size(); i += 6) append_yuyv_pair(&bgr[i], &bgr[i + 3], bytes);
  }
  return bytes;
}

void LoopbackCamera::show(std::span<const std::uint8_t> encoded) {
  if (write(device_.get(), encoded.data(), encoded.size()) != static_cast<ssize_t>(encoded.size()))
    fail(kExitIo, params_.device, "does not take a picture");
}

}  // namespace hindsight::tools
