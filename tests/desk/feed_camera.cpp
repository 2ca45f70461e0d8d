// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The world in front of the desk vehicle's camera: writes the pictures of a folder, in the order of their
// names, into a v4l2loopback output device at a steady rate, as a camera of the given size and format would
// give them.
#include <fcntl.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace {

using Bytes = std::vector<std::uint8_t>;

struct Options {
  std::string frames;
  std::string device = "/dev/video10";
  std::string format = "mjpeg";
  int width_px = 720;
  int height_px = 480;
  int count = 150;
  double rate_hz = 10.0;
};

// BT.601, limited range: what V4L2 cameras mean by YUYV. `x` is even; the pair shares the left pixel's
// chroma.
void append_yuyv_pair(Bytes& out, const cv::Vec3b& left, const cv::Vec3b& right) {
  const auto clamp = [](double v) { return static_cast<std::uint8_t>(std::clamp(v + 0.5, 0.0, 255.0)); };
  const auto luma = [&](const cv::Vec3b& p) {
    return clamp(16.0 + 0.257 * p[2] + 0.504 * p[1] + 0.098 * p[0]);
  };
  out.push_back(luma(left));
  out.push_back(clamp(128.0 - 0.148 * left[2] - 0.291 * left[1] + 0.439 * left[0]));
  out.push_back(luma(right));
  out.push_back(clamp(128.0 + 0.439 * left[2] - 0.368 * left[1] - 0.071 * left[0]));
}

Bytes encode(const cv::Mat& bgr, const std::string& format) {
  Bytes bytes;
  if (format == "mjpeg") {
    cv::imencode(".jpg", bgr, bytes, {cv::IMWRITE_JPEG_QUALITY, 90});
    return bytes;
  }
  bytes.reserve(bgr.total() * 2);
  for (int y = 0; y < bgr.rows; ++y) {
    for (int x = 0; x + 1 < bgr.cols; x += 2) {
      append_yuyv_pair(bytes, bgr.at<cv::Vec3b>(y, x), bgr.at<cv::Vec3b>(y, x + 1));
    }
  }
  return bytes;
}

// Encoded before the drive, so that feeding costs the one processor of the desk next to nothing.
std::vector<Bytes> load(const Options& options) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(options.frames)) {
    const std::string kind = entry.path().extension().string();
    if (kind == ".jpg" || kind == ".png") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  if (paths.empty()) throw std::runtime_error(options.frames + " holds no .jpg and no .png");
  if (static_cast<int>(paths.size()) > options.count) paths.resize(static_cast<std::size_t>(options.count));
  std::vector<Bytes> frames;
  for (const auto& path : paths) {
    const cv::Mat picture = cv::imread(path.string(), cv::IMREAD_COLOR);
    if (picture.empty()) throw std::runtime_error("cannot read the picture " + path.string());
    cv::Mat sized;
    cv::resize(picture, sized, {options.width_px, options.height_px}, 0.0, 0.0, cv::INTER_AREA);
    frames.push_back(encode(sized, options.format));
  }
  return frames;
}

int open_output(const Options& options) {
  const int device = open(options.device.c_str(), O_WRONLY | O_CLOEXEC);
  if (device < 0) throw std::system_error(errno, std::generic_category(), options.device);
  v4l2_format format{};
  format.type = V4L2_BUF_TYPE_VIDEO_OUTPUT;
  format.fmt.pix.width = static_cast<std::uint32_t>(options.width_px);
  format.fmt.pix.height = static_cast<std::uint32_t>(options.height_px);
  format.fmt.pix.pixelformat = options.format == "mjpeg" ? V4L2_PIX_FMT_MJPEG : V4L2_PIX_FMT_YUYV;
  format.fmt.pix.sizeimage = format.fmt.pix.width * format.fmt.pix.height * 2;
  format.fmt.pix.bytesperline = options.format == "mjpeg" ? 0 : format.fmt.pix.width * 2;
  format.fmt.pix.field = V4L2_FIELD_NONE;
  format.fmt.pix.colorspace = V4L2_COLORSPACE_SRGB;
  if (ioctl(device, VIDIOC_S_FMT, &format) != 0) {
    throw std::system_error(errno, std::generic_category(), options.device + ": VIDIOC_S_FMT");
  }
  return device;
}

// Until it is told to stop: forth and back through the frames, so that the picture never jumps.
void feed(int device, const std::vector<Bytes>& frames, double rate_hz) {
  const auto period = std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(1.0 / rate_hz));
  auto due = std::chrono::steady_clock::now();
  std::size_t i = 0;
  bool forth = true;
  while (true) {
    const Bytes& frame = frames[i];
    if (write(device, frame.data(), frame.size()) != static_cast<ssize_t>(frame.size())) {
      throw std::system_error(errno, std::generic_category(), "writing a frame");
    }
    if (i + 1 == frames.size()) forth = false;
    if (i == 0) forth = true;
    if (frames.size() > 1) i = forth ? i + 1 : i - 1;
    due += period;
    std::this_thread::sleep_until(due);
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Feeds the pictures of a folder to a v4l2loopback device until it is killed."};
  app.add_option("--frames", options.frames, "folder of .jpg or .png pictures")->required();
  app.add_option("--device", options.device, "the v4l2loopback output device");
  app.add_option("--format", options.format, "what the camera gives")
      ->check(CLI::IsMember({"mjpeg", "yuyv"}));
  app.add_option("--width", options.width_px, "[px]");
  app.add_option("--height", options.height_px, "[px]");
  app.add_option("--count", options.count, "at most so many pictures");
  app.add_option("--rate", options.rate_hz, "[Hz]");
  CLI11_PARSE(app, argc, argv);
  try {
    const std::vector<Bytes> frames = load(options);
    const int device = open_output(options);
    std::printf("feeding %zu frames to %s\n", frames.size(), options.device.c_str());
    std::fflush(stdout);
    feed(device, frames, options.rate_hz);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "feed_camera: %s\n", error.what());
    return 1;
  }
}
