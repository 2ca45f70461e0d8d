// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The world in front of the desk vehicle's camera: writes the pictures of a folder, in the order of their
// names, into a v4l2loopback output device at a steady rate, as a camera of the given size and format would
// give them.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tools/loopback_camera.h"

namespace {

using hindsight::tools::LoopbackCamera;
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

// Encoded before the drive, so that feeding costs the one processor of the desk next to nothing.
std::vector<Bytes> load(const Options& options, const LoopbackCamera& camera) {
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
    frames.push_back(camera.encode({sized.data, sized.total() * sized.elemSize()}));
  }
  return frames;
}

// Until it is told to stop: forth and back through the frames, so that the picture never jumps.
void feed(LoopbackCamera& camera, const std::vector<Bytes>& frames, double rate_hz) {
  const auto period = std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(1.0 / rate_hz));
  auto due = std::chrono::steady_clock::now();
  std::size_t i = 0;
  bool forth = true;
  while (true) {
    camera.show(frames[i]);
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
    LoopbackCamera camera({.device = options.device,
                           .width_px = options.width_px,
                           .height_px = options.height_px,
                           .format = options.format,
                           .rate_hz = options.rate_hz});
    const std::vector<Bytes> frames = load(options, camera);
    std::printf("feeding %zu frames to %s\n", frames.size(), options.device.c_str());
    std::fflush(stdout);
    feed(camera, frames, options.rate_hz);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "feed_camera: %s\n", error.what());
    return 1;
  }
}
