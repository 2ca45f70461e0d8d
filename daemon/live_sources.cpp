// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/live_sources.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include "daemon/thread_setup.h"
#include "drivers/monotonic_clock.h"
#include "drivers/vehicle_decoder.h"

namespace hindsight {
namespace {

/// How long a driver may wait; also how often its thread beats.
constexpr Time kServicePeriod = from_seconds(0.05);

/// Frames that may be held at once: in the recorder's queue, the publisher's, the loop's and the camera's hands.
std::size_t frames_in_flight(const Configuration& configuration) {
  return static_cast<std::size_t>(configuration.recorder.queue_ticks) + 10;
}

std::size_t pixels_of(const CameraFormatParams& format) {
  return static_cast<std::size_t>(format.width_px) * static_cast<std::size_t>(format.height_px);
}

}  // namespace

void LiveSources::LineSink::on_edge(const LineEdge& edge) {
  board_.see(edge);
  reflex_.wake();
  SampleQueue::on_edge(edge);
}

void LiveSources::LineSink::on_report(const SourceReport& report) {
  board_.lines_ok.store(report.state == SourceState::fresh, std::memory_order_relaxed);
  reflex_.wake();
  SampleQueue::on_report(report);
}

void LiveSources::BusSink::on_report(const SourceReport& report) {
  board_.bus_ok.store(report.state == SourceState::fresh, std::memory_order_relaxed);
  SampleQueue::on_report(report);
}

LiveSources::LiveSources(const Configuration& configuration, const Dbc& dbc, ReflexBoard& board, LiveReflex& reflex,
                         Heartbeats& heartbeats)
    : heartbeats_(heartbeats),
      stop_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      pool_(frames_in_flight(configuration), frame_bytes(configuration.camera.format),
            pixels_of(configuration.camera.format)),
      bus_(board),
      lines_(board, reflex) {
  const std::vector<std::uint32_t> ids = VehicleDecoder(dbc, configuration.can_roles).received_ids();
  camera_ = std::make_unique<V4l2Camera>(configuration.camera, pool_, frames_);
  can_ = std::make_unique<SocketCanBus>(configuration.can, ids, bus_);
  gpio_ = std::make_unique<GpioLines>(configuration.gpio, lines_);
  if (configuration.gps.enabled) gps_ = std::make_unique<GpsdClient>(configuration.gps, fixes_);
  if (!configuration.command.listen.empty()) receiver_ = std::make_unique<CommandReceiver>(configuration.command);
  serve(ThreadId::camera, *camera_);
  serve(ThreadId::can, *can_);
  serve(ThreadId::gpio, *gpio_);
  if (gps_) serve(ThreadId::gps, *gps_);
  if (receiver_) serve_commands();
}

LiveSources::~LiveSources() {
  stopping_.store(true);
  const std::uint64_t one = 1;
  static_cast<void>(!write(stop_.get(), &one, sizeof one));
  for (std::thread& thread : threads_) thread.join();
}

template <typename Driver>
void LiveSources::serve(ThreadId id, Driver& driver) {
  threads_.emplace_back([this, id, &driver] {
    name_this_thread(kThreadNames[static_cast<std::size_t>(id)]);
    while (!stopping_.load(std::memory_order_relaxed)) {
      driver.service(kServicePeriod, stop_.get());
      heartbeats_.beat(id, monotonic_now());
    }
  });
}

void LiveSources::serve_commands() {
  threads_.emplace_back([this] {
    name_this_thread("command");
    std::vector<OperatorCommand> accepted;
    while (!stopping_.load(std::memory_order_relaxed)) {
      accepted.clear();
      receiver_->service(kServicePeriod, stop_.get(), accepted);
      for (const OperatorCommand& command : accepted) commands_.on_command(command);
      heartbeats_.beat(ThreadId::command, monotonic_now());
    }
  });
}

void LiveSources::drain_into(TickInput& input) {
  for (SampleQueue* queue : {static_cast<SampleQueue*>(&frames_), static_cast<SampleQueue*>(&bus_),
                             static_cast<SampleQueue*>(&lines_), &fixes_, &commands_}) {
    queue->drain_into(input);
  }
}

}  // namespace hindsight
