// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/bench_robot.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "config/exit_code.h"
#include "daemon/flight_recorder.h"
#include "daemon/replay_run.h"
#include "drivers/monotonic_clock.h"
#include "sim_replay/run_log_writer.h"
#include "tools/allocation_counter.h"
#include "tools/bench_drive.h"
#include "tools/cpu_time.h"
#include "tools/opencv_flow.h"

namespace hindsight::tools {
namespace {

constexpr std::uint64_t kWarmUpTicks = 30;
constexpr std::uint64_t kTicks = 150;
constexpr std::uint64_t kReplayTicks = 100;

/// A robot on a drive of its own.
struct Car {
  Car(std::span<const cv::Mat> frames, const Configuration& configuration)
      : robot(BenchDrive::setup(configuration)), drive(frames) {
    input.reserve();
  }
  void step(std::uint64_t tick) {
    drive.fill(tick, input);
    outbox.clear();
    const std::uint64_t before = allocations_of_this_thread();
    const double us = microseconds([&] { robot.step(input, outbox); });
    const std::uint64_t made = allocations_of_this_thread() - before;
    if (tick < kWarmUpTicks) return;
    ms.push_back(us * 1e-3);
    // A training event may make messages and mixture grow: not the steady state.
    if (robot.learner().lessons().empty()) allocations = std::max(allocations, made);
  }

  Robot robot;
  BenchDrive drive;
  TickInput input;
  Outbox outbox;
  std::vector<double> ms;
  std::uint64_t allocations = 0;
};

/// OpenCV's smoothing, features and flow with a configuration's parameters.
struct Yardstick {
  explicit Yardstick(const Configuration& configuration) : flow(configuration.flow) {}
  void run(const cv::Mat& grey, bool counts) {
    const double us = microseconds([&] { flow.update_grey(grey); });
    if (counts) ms.push_back(us * 1e-3);
  }

  OpencvFlow flow;
  std::vector<double> ms;
};

double resident_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmRSS:")) return std::strtod(line.c_str() + 6, nullptr) / 1024.0;
  }
  return 0.0;
}

void record_drive(std::span<const cv::Mat> bgr_frames, const Configuration& configuration, const std::string& path) {
  BenchDrive drive(bgr_frames);
  RunLogWriter writer(path);
  writer.write_header(BenchDrive::header(configuration));
  TickInput input;
  input.reserve();
  for (std::uint64_t tick = 0; tick < kReplayTicks; ++tick) {
    drive.fill(tick, input);
    Frame& frame = FrameRef(input.frame).writable();
    frame.format = PixelFormat::mjpeg;
    cv::imencode(".jpg", cv::Mat(frame.height_px, frame.width_px, CV_8UC3, frame.bgr.data()), frame.bytes);
    writer.write_tick(input);
  }
  if (!writer.close()) throw FatalError(kExitIo, path + ": cannot be written");
}

}  // namespace

TickBench bench_tick(std::span<const cv::Mat> bgr_frames, const Configuration& thesis, const Configuration& standard) {
  Car thesis_car(bgr_frames, thesis), standard_car(bgr_frames, standard);
  Yardstick thesis_yardstick(thesis), standard_yardstick(standard);
  cv::Mat grey;
  for (std::uint64_t tick = 0; tick < kWarmUpTicks + kTicks; ++tick) {
    thesis_car.step(tick);
    standard_car.step(tick);
    const std::uint64_t place = tick % bgr_frames.size();
    cv::cvtColor(bgr_frames[place], grey, cv::COLOR_BGR2GRAY);
    const bool counts = tick >= kWarmUpTicks && place != 0;  // there the frames begin anew
    thesis_yardstick.run(grey, counts);
    standard_yardstick.run(grey, counts);
  }
  return {quantile(thesis_car.ms, 0.5), quantile(standard_car.ms, 0.5), quantile(thesis_yardstick.ms, 0.5),
          quantile(standard_yardstick.ms, 0.5), static_cast<double>(standard_car.allocations)};
}

double bench_resident_mb(std::span<const cv::Mat> bgr_frames, const Configuration& configuration) {
  int ends[2];
  if (pipe(ends) != 0) throw FatalError(kExitSoftware, "cannot make a pipe");
  const pid_t child = fork();
  if (child == 0) {
    Car car(bgr_frames, configuration);
    FlightRecorderParams remembered = configuration.flight_recorder;
    remembered.folder = std::filesystem::temp_directory_path().string();  // nothing is written: there is no fault
    FlightRecorder flight(remembered, BenchDrive::header(configuration));
    TickRecord record;
    const auto ticks = static_cast<std::uint64_t>(configuration.flow_history.depth) + 20;
    for (std::uint64_t tick = 0; tick < ticks; ++tick) {
      car.step(tick);
      record.input = car.input;
      flight.take(record);
    }
    const double mb = resident_mb();
    _exit(write(ends[1], &mb, sizeof mb) == sizeof mb ? 0 : 1);
  }
  double mb = 0.0;
  close(ends[1]);
  const bool told = read(ends[0], &mb, sizeof mb) == sizeof mb;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  if (!told) throw FatalError(kExitSoftware, "the process that measures memory ended early");
  return mb;
}

double bench_replay_over_realtime(std::span<const cv::Mat> bgr_frames, const Configuration& configuration) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("hindsight_bench_" + std::to_string(getpid()) + ".lcm")).string();
  record_drive(bgr_frames, configuration, path);
  const Time began = monotonic_now();
  ReplayRun run(path, std::nullopt, false);
  while (run.step()) {
  }
  const double seconds = to_seconds(monotonic_now() - began);
  std::filesystem::remove(path);
  return static_cast<double>(kReplayTicks) / configuration.robot.loop_rate_hz / seconds;
}

}  // namespace hindsight::tools
