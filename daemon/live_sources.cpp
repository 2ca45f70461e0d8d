// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/live_sources.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include "daemon/beating_thread.h"
#include "daemon/thread_setup.h"
#include "drivers/monotonic_clock.h"
#include "drivers/vehicle_decoder.h"

namespace hindsight {
namespace {

/// How long a driver may wait; also how often its thread beats.
constexpr Time kServicePeriod = from_seconds(0.05);
constexpr int kOrdinary = 0;

/// Frames that may be held at once: in the recorders' queues, the publisher's, the loop's and the camera's hands.
std::size_t frames_in_flight(const Configuration& configuration) {
  return static_cast<std::size_t>(configuration.recorder.queue_ticks) + 14;
}

std::size_t pixels_of(const CameraFormatParams& format) {
  return static_cast<std::size_t>(format.width_px) * static_cast<std::size_t>(format.height_px);
}

}  // namespace

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
  serve(ThreadId::camera, kOrdinary, [this] { camera_->service(kServicePeriod, stop_.get()); });
  serve(ThreadId::can, kOrdinary, [this] { can_->service(kServicePeriod, stop_.get()); });
  // The way from a bumper to the wheels is as fast as the slower of its two threads.
  serve(ThreadId::gpio, configuration.reflex.realtime_priority, [this] {
    gpio_->service(kServicePeriod, stop_.get());
    lines_.looked(monotonic_now());
  });
  if (gps_) serve(ThreadId::gps, kOrdinary, [this] { gps_->service(kServicePeriod, stop_.get()); });
  if (receiver_) {
    serve(ThreadId::command, kOrdinary, [this, accepted = std::vector<OperatorCommand>{}]() mutable {
      accepted.clear();
      receiver_->service(kServicePeriod, stop_.get(), accepted);
      for (const OperatorCommand& command : accepted) commands_.on_command(command);
    });
  }
}

LiveSources::~LiveSources() {
  stopping_.store(true);
  const std::uint64_t one = 1;
  static_cast<void>(!write(stop_.get(), &one, sizeof one));
  for (std::thread& thread : threads_) thread.join();
}

void LiveSources::serve(ThreadId id, int priority, std::function<void()> service) {
  threads_.push_back(start_beating_thread(id, heartbeats_, [this, id, priority, service = std::move(service)] {
    make_this_thread_realtime(priority);
    while (!stopping_.load(std::memory_order_relaxed)) {
      service();
      heartbeats_.beat(id, monotonic_now());
    }
  }));
}

void LiveSources::drain_into(TickInput& input) {
  for (SampleQueue* queue : {static_cast<SampleQueue*>(&frames_), static_cast<SampleQueue*>(&bus_),
                             static_cast<SampleQueue*>(&lines_), &fixes_, &commands_}) {
    queue->drain_into(input);
  }
}

}  // namespace hindsight
