// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/live_run.h"

#include <poll.h>
#include <signal.h>
#include <sys/signalfd.h>
#include <systemd/sd-daemon.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <thread>

#include "config/exit_code.h"
#include "daemon/flight_recorder.h"
#include "daemon/loop.h"
#include "daemon/model_store.h"
#include "daemon/publisher.h"
#include "daemon/run_setup.h"
#include "daemon/say.h"
#include "daemon/saved_state.h"
#include "daemon/thread_judge.h"
#include "daemon/thread_setup.h"
#include "daemon/unix_clock.h"
#include "drivers/monotonic_clock.h"
#include "perception/mixture_codec.h"
#include "sim_replay/run_log_writer.h"

namespace hindsight {
namespace {

constexpr int kPublisherQueue = 4;
constexpr int kFlightQueue = 4;
constexpr int kHousekeeping_ms = 100;
/// Ten periods of the reflex.
constexpr auto kTimeForZero = std::chrono::milliseconds(100);
constexpr int kLastLooks = 10;

/// SIGTERM and SIGINT as a descriptor. Made before any thread, so that all inherit the blocked signals.
UniqueFd termination_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return UniqueFd(signalfd(-1, &signals, SFD_CLOEXEC | SFD_NONBLOCK));
}

void record_tick(RunLogWriter& writer, const TickRecord& record) {
  if (!writer.ok()) return;
  writer.write_tick(record.input);
  for (const Outbox::Message& message : record.outbox.messages()) {
    writer.write_published(message.channel, message.utime_us, message.bytes);
  }
  if (!writer.flush()) say(Severity::warning, "recording ended: {}", std::strerror(writer.error_code()));
}

void save(const char* what, const std::string& file, std::span<const std::uint8_t> bytes) {
  const std::string problem = save_atomically(file, bytes);
  if (problem.empty()) {
    say(Severity::notice, "{} saved to {}", what, file);
  } else {
    say(Severity::warning, "{} not saved: {}", what, problem);
  }
}

void save_memory(const RobotParams& robot, const Memory& memory) {
  if (!robot.model_file.empty() && !memory.mixture.components.empty()) {
    save("model", robot.model_file, encode_mixture(memory.mixture));
  }
  if (!robot.state_file.empty()) save("state", robot.state_file, encode_state(memory.state));
}

/// The main thread's work: judges the other threads, alone feeds the watchdog, tells systemd and the log how it stands.
class Housekeeper {
 public:
  Housekeeper(const Configuration& configuration, const Heartbeats& heartbeats, const LoopStatus& status)
      : judge_(heartbeats, from_seconds(configuration.robot.watchdog_s)), status_(status) {}

  ThreadVerdict look() {
    const ThreadVerdict verdict = judge_.look(monotonic_now());
    if (verdict == ThreadVerdict::well) sd_notify(0, "WATCHDOG=1");
    tell_ready();
    tell_reason();
    return verdict;
  }
  std::string_view culprit() const { return judge_.culprit(); }

 private:
  void tell_ready() {
    if (told_ready_ || !status_.ready.load(std::memory_order_relaxed)) return;
    told_ready_ = true;
    sd_notify(0, "READY=1");
    say(Severity::notice, "ready: camera, CAN bus and GPIO lines give data");
  }
  void tell_reason() {
    const int reason = status_.reason.load(std::memory_order_relaxed);
    if (status_.ticks.load(std::memory_order_relaxed) == 0 || reason == told_reason_) return;
    told_reason_ = reason;
    const char* name = reason == 0 ? "may move" : name_of(static_cast<StopReason>(reason));
    sd_notifyf(0, "STATUS=%s%s", reason == 0 ? "" : "stopped: ", name);
    say(Severity::notice, "{}{}", reason == 0 ? "" : "stopped: ", name);
  }

  ThreadJudge judge_;
  const LoopStatus& status_;
  bool told_ready_ = false;
  int told_reason_ = -1;
};

/// A thread that hangs cannot be joined, so the process ends as it is, once the reflex has had time to send its zero and
/// the flight recorder to write (unless it is who hangs). The run log is with the kernel after each tick.
[[noreturn]] void end_with_hung_thread(FlightRecorder* flight) {
  if (flight != nullptr) flight->request(StopReason::thread);
  for (int i = 0; i < kLastLooks && (i == 0 || (flight != nullptr && !flight->idle())); ++i) {
    std::this_thread::sleep_for(kTimeForZero);
  }
  std::_Exit(kExitSoftware);
}

}  // namespace

int run_live(const LiveJob& job) {
  const UniqueFd signals = termination_signals();
  const Configuration configuration = with_saved_state(load_configuration(job.configuration_files));
  const RunHeader materials = load_materials(configuration);
  const RobotSetup setup = make_setup(configuration, materials, "");
  const CameraFormatParams& format = configuration.camera.format;
  setup.camera.require_size(format.width_px, format.height_px);
  Robot robot(setup);

  Heartbeats heartbeats;
  ReflexBoard board;
  std::optional<RunLogWriter> writer;
  if (!job.record.empty()) {
    writer.emplace(job.record);
    writer->write_header(materials);
  }
  std::optional<FlightRecorder> flight;
  if (!configuration.flight_recorder.folder.empty()) flight.emplace(configuration.flight_recorder, materials);
  // Ended in the reverse order: the loop first, then the sources, then the reflex with its zero, then the log.
  TickRecordPool records(static_cast<std::size_t>(configuration.recorder.queue_ticks + kPublisherQueue + kFlightQueue + 4));
  LiveReflex reflex(configuration, setup.dbc, board, heartbeats);
  Publisher publisher(configuration.telemetry);
  std::optional<LiveSources> sources(std::in_place, configuration, setup.dbc, board, reflex, heartbeats);
  ThreadVerdict verdict = ThreadVerdict::well;
  {
    TickConsumer publishing(ThreadId::publisher, kPublisherQueue, heartbeats, [&](const TickRecord& record) {
      publisher.publish(record.outbox, record.input.frame, record.input.now, record.input.utime_us);
    });
    std::optional<TickConsumer> recording;
    if (writer) {
      recording.emplace(ThreadId::recorder, static_cast<std::size_t>(configuration.recorder.queue_ticks), heartbeats,
                        [&](const TickRecord& record) { record_tick(*writer, record); });
    }
    std::optional<TickConsumer> remembering;
    if (flight) {
      remembering.emplace(
          ThreadId::flight_recorder, kFlightQueue, heartbeats,
          [&](const TickRecord& record) { flight->take(record); }, [&] { flight->look_after(monotonic_now()); });
    }
    Loop loop(configuration, robot, *sources, reflex, board, records, publishing, recording ? &*recording : nullptr,
              remembering ? &*remembering : nullptr, heartbeats);
    if (configuration.robot.lock_memory) lock_memory();
    Housekeeper housekeeper(configuration, heartbeats, loop.status());
    say(Severity::info, "running at {:g} Hz", configuration.robot.loop_rate_hz);
    pollfd signal{signals.get(), POLLIN, 0};
    while (poll(&signal, 1, kHousekeeping_ms) == 0 && verdict == ThreadVerdict::well) {
      verdict = housekeeper.look();
      if (const auto memory = loop.take_memory_to_save()) save_memory(configuration.robot, *memory);
    }
    if (verdict != ThreadVerdict::well) {
      board.thread_lost.store(true);
      if (flight && verdict == ThreadVerdict::died) flight->request(StopReason::thread);
      reflex.wake();
      say(Severity::error, "thread {} {}: the vehicle is stopped, the process ends", housekeeper.culprit(),
          verdict == ThreadVerdict::died ? "died" : "hangs");
    }
    sd_notify(0, "STOPPING=1");
    if (verdict == ThreadVerdict::hung) end_with_hung_thread(flight ? &*flight : nullptr);
  }
  save_memory(configuration.robot, memory_of(robot, unix_now_us()));
  sources.reset();
  if (writer && !writer->close()) say(Severity::warning, "the log is incomplete: {}", std::strerror(writer->error_code()));
  return verdict == ThreadVerdict::well ? kExitOk : kExitSoftware;
}

}  // namespace hindsight
