// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/sim_devices.h"

#include <linux/can.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "config/exit_code.h"
#include "daemon/run_setup.h"
#include "drivers/can_sender.h"
#include "drivers/can_socket.h"
#include "drivers/drive_command_codec.h"
#include "drivers/monotonic_clock.h"
#include "sim_replay/vehicle/sim_vehicle.h"
#include "tools/gpsd_server.h"
#include "tools/loopback_camera.h"
#include "tools/sim_feed.h"
#include "tools/simulated_lines.h"

namespace hindsight::tools {
namespace {

constexpr Time kTellEvery = std::chrono::seconds(1);
/// A base that was held up for longer does not drive on through the time that it has missed.
constexpr Time kLongestCatchUp = std::chrono::milliseconds(100);

/// The robot's commands, as they come over the bus.
class CommandReader {
 public:
  CommandReader(const std::string& interface, const DriveCommandCodec& codec) : codec_(codec) {
    DeviceError error;
    const std::array ids{codec.id()};
    socket_ = open_can_receiver(interface, ids, error);
    if (!socket_) throw FatalError(kExitNoDevice, error.message);
  }

  /// The newest good one since the last call.
  std::optional<WheelCommand> newest() {
    std::optional<WheelCommand> command;
    can_frame raw{};
    while (read(socket_.get(), &raw, sizeof raw) == static_cast<ssize_t>(sizeof raw)) {
      CanFrame frame{.stamp = {}, .id = raw.can_id, .length = raw.can_dlc, .data = {}};
      std::copy_n(raw.data, frame.data.size(), frame.data.begin());
      WheelSetpoints setpoints;
      std::uint32_t counter = 0;
      if (!codec_.decode(frame, setpoints, counter)) continue;
      ++received_;
      command = setpoints.enable ? WheelCommand{setpoints.left_mps, setpoints.right_mps} : WheelCommand{};
    }
    return command;
  }

  std::uint64_t received() const { return received_; }

 private:
  const DriveCommandCodec& codec_;
  UniqueFd socket_;
  std::uint64_t received_ = 0;
};

/// Draws what the camera sees from where the body is, on a thread of its own. Its failure ends the run.
class CameraThread {
 public:
  CameraThread(const DevicesRun& run, const CameraModel& model, const BodyPose& X_WB)
      : X_WB_(X_WB), thread_([this, &run, &model] { show(run, model); }) {}
  ~CameraThread() {
    stop_ = true;
    thread_.join();
  }

  void move_to(const BodyPose& X_WB) {
    const std::lock_guard lock(mutex_);
    X_WB_ = X_WB;
  }
  std::uint64_t frames() const { return frames_; }
  void rethrow_failure() const {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  BodyPose pose() const {
    const std::lock_guard lock(mutex_);
    return X_WB_;
  }

  void show(const DevicesRun& run, const CameraModel& model) {
    try {
      LoopbackCamera camera(run.configuration.camera.format);
      Renderer renderer(run.world, render_camera(model), run.seed);
      const Time period = from_seconds(1.0 / run.configuration.camera.format.rate_hz);
      const Time began = monotonic_now();
      BodyPose before = pose();
      for (Time due = began; !stop_; due = std::max(due + period, monotonic_now())) {
        std::this_thread::sleep_for(due - monotonic_now());
        const BodyPose now = pose();
        const RenderedFrame& frame = renderer.render(now, std::exchange(before, now), to_seconds(period),
                                                     to_seconds(due - began), false);
        camera.show(camera.encode(frame.bgr));
        ++frames_;
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
    }
  }

  mutable std::mutex mutex_;
  BodyPose X_WB_;
  std::exception_ptr failure_;
  std::atomic<bool> stop_ = false;
  std::atomic<std::uint64_t> frames_ = 0;
  std::thread thread_;
};

/// Where what the vehicle says goes out.
class Outlets {
 public:
  explicit Outlets(const Configuration& configuration)
      : bus_(configuration.can.interface, configuration.can.reopen), lines_(configuration.gpio) {
    if (configuration.gps.enabled) gpsd_.emplace(configuration.gps);
  }

  void say(const TickInput& samples) {
    for (const CanFrame& frame : samples.can) bus_.send(frame, samples.now);
    for (const LineEdge& edge : samples.edges) lines_.pull(edge);
    if (gpsd_) gpsd_->serve(samples.fixes);
  }

 private:
  CanSender bus_;
  SimulatedLines lines_;
  std::optional<GpsdServer> gpsd_;
};

void check_sizes(const CameraFormatParams& camera, const CameraModel& model) {
  if (camera.width_px == model.width_px && camera.height_px == model.height_px) return;
  throw FatalError(kExitConfiguration, "camera.width_px and height_px are not those of the calibration");
}

}  // namespace

DevicesSummary run_on_devices(const DevicesRun& run, const std::atomic<bool>& stop,
                              const std::function<void(const DevicesSummary&)>& tell) {
  const Configuration& configuration = run.configuration;
  const RobotSetup setup = make_setup(configuration, load_materials(configuration), "");
  check_sizes(configuration.camera.format, setup.camera);
  const DriveCommandCodec codec(setup.dbc, configuration.can_roles);
  CommandReader commands(configuration.can.interface, codec);
  Outlets outlets(configuration);
  SimVehicle vehicle(configuration.vehicle, run.world, setup.dbc, configuration.can_roles,
                     configuration.training.ir_threshold_m, run.seed);
  CameraThread camera(run, setup.camera, vehicle.pose());

  const Time began = monotonic_now();
  const auto summary = [&](Time now) {
    const BodyPose& X_WB = vehicle.pose();
    return DevicesSummary{
        .seconds = to_seconds(now - began),
        .to_goal_m = std::hypot(run.world.goal.x_m - X_WB.x_m, run.world.goal.y_m - X_WB.y_m),
        .distance_m = vehicle.distance_m(),
        .touches = vehicle.touches(),
        .ir_touches = vehicle.ir_touches(),
        .commands = commands.received(),
        .frames = camera.frames()};
  };
  TickInput samples;
  samples.reserve();
  samples.now = began;
  vehicle.report_lines(began, samples.edges);
  outlets.say(samples);
  Time told = began;
  while (!stop && samples.now - began < from_seconds(run.seconds)) {
    samples.clear();
    samples.now = std::max(samples.now + SimVehicle::kPeriod, monotonic_now() - kLongestCatchUp);
    std::this_thread::sleep_for(samples.now - monotonic_now());
    vehicle.step(samples.now, commands.newest(), samples);
    outlets.say(samples);
    camera.move_to(vehicle.pose());
    camera.rethrow_failure();
    if (samples.now - told < kTellEvery) continue;
    told = samples.now;
    tell(summary(told));
  }
  return summary(samples.now);
}

}  // namespace hindsight::tools
