// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/live_run.h"

#include <poll.h>
#include <signal.h>
#include <sys/signalfd.h>
#include <systemd/sd-daemon.h>

#include <cstring>
#include <optional>

#include "config/exit_code.h"
#include "daemon/loop.h"
#include "daemon/model_store.h"
#include "daemon/publisher.h"
#include "daemon/run_setup.h"
#include "daemon/say.h"
#include "daemon/saved_state.h"
#include "daemon/unix_clock.h"
#include "drivers/monotonic_clock.h"
#include "perception/mixture_codec.h"
#include "sim_replay/run_log_writer.h"

namespace hindsight {
namespace {

constexpr int kPublisherQueue = 4;
constexpr int kHousekeeping_ms = 100;

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

/// The main thread's work: judges the heartbeats, alone feeds the watchdog, tells systemd and the log how it stands.
class Housekeeper {
 public:
  Housekeeper(const Configuration& configuration, const Heartbeats& heartbeats, const LoopStatus& status)
      : limit_(from_seconds(configuration.robot.watchdog_s)), heartbeats_(heartbeats), status_(status) {}

  void look() {
    const std::string_view late = heartbeats_.late(monotonic_now(), limit_);
    if (late.empty()) {
      sd_notify(0, "WATCHDOG=1");
    } else if (late != told_late_) {
      say(Severity::error, "thread {} has been silent for more than {:.1f} s", late, to_seconds(limit_));
    }
    told_late_ = late;
    tell_ready();
    tell_reason();
  }

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

  Time limit_;
  const Heartbeats& heartbeats_;
  const LoopStatus& status_;
  std::string_view told_late_;
  bool told_ready_ = false;
  int told_reason_ = -1;
};

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
  // Ended in the reverse order: the loop first, then the sources, then the reflex with its zero, then the log.
  TickRecordPool records(static_cast<std::size_t>(configuration.recorder.queue_ticks + kPublisherQueue + 3));
  LiveReflex reflex(configuration, setup.dbc, board, heartbeats);
  Publisher publisher(configuration.telemetry);
  std::optional<LiveSources> sources(std::in_place, configuration, setup.dbc, board, reflex, heartbeats);
  bool failed = false;
  {
    TickConsumer publishing(ThreadId::publisher, kPublisherQueue, heartbeats, [&](const TickRecord& record) {
      publisher.publish(record.outbox, record.input.frame, record.input.now, record.input.utime_us);
    });
    std::optional<TickConsumer> recording;
    if (writer) {
      recording.emplace(ThreadId::recorder, static_cast<std::size_t>(configuration.recorder.queue_ticks), heartbeats,
                        [&](const TickRecord& record) { record_tick(*writer, record); });
    }
    Loop loop(configuration, robot, *sources, reflex, board, records, publishing, recording ? &*recording : nullptr,
              heartbeats);
    Housekeeper housekeeper(configuration, heartbeats, loop.status());
    say(Severity::info, "running at {:g} Hz", configuration.robot.loop_rate_hz);
    pollfd signal{signals.get(), POLLIN, 0};
    while (poll(&signal, 1, kHousekeeping_ms) == 0 && !failed) {
      housekeeper.look();
      if (const auto memory = loop.take_memory_to_save()) save_memory(configuration.robot, *memory);
      failed = loop.status().failed.load();
    }
    sd_notify(0, "STOPPING=1");
  }
  save_memory(configuration.robot, memory_of(robot, unix_now_us()));
  sources.reset();
  if (writer && !writer->close()) say(Severity::warning, "the log is incomplete: {}", std::strerror(writer->error_code()));
  return failed ? kExitSoftware : kExitOk;
}

}  // namespace hindsight
