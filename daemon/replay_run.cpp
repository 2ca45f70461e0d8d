// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/replay_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <thread>
#include <utility>

#include "config/exit_code.h"
#include "daemon/publisher.h"
#include "daemon/run_setup.h"
#include "daemon/say.h"
#include "drivers/frame_decoder.h"
#include "drivers/monotonic_clock.h"
#include "sim_replay/read_file.h"
#include "sim_replay/run_log_writer.h"

namespace hindsight {
namespace {

/// One frame in the tick at hand and those that the source reads ahead.
constexpr std::size_t kFramesInFlight = 4;

bool decode(Frame& frame) { return decode_frame(frame) == DecodeResult::ok; }

RunHeader required_header(const ReplaySource& source, const std::string& log) {
  if (!source.header()) {
    throw FatalError(kExitBadData, log + ": has no run header; logs come from hindsightd --record or hindsight import");
  }
  return *source.header();
}

Configuration chosen(const RunHeader& header, const std::optional<Configuration>& given) {
  return given ? *given : configuration_of(header);
}

/// What an imported log lacks comes from the configuration's files.
RunHeader completed(RunHeader header, const Configuration& configuration) {
  header.configuration = to_text(configuration);
  header.build_id = build_id();
  if (header.dbc.empty()) header.dbc = read_file<std::string>(configuration.can_roles.dbc);
  if (!header.ticks_recorded) header.mixture = load_saved_mixture(configuration);
  return header;
}

/// Waits until the run's time has come, `pace` times as fast as it was recorded.
class Pacer {
 public:
  explicit Pacer(double pace) : pace_(pace) {}
  void wait_for(Time run_time) {
    if (pace_ <= 0.0) return;
    if (!std::exchange(started_, true)) {
      wall_start_ = monotonic_now();
      run_start_ = run_time;
    }
    const Time due = wall_start_ + from_seconds(to_seconds(run_time - run_start_) / pace_);
    std::this_thread::sleep_for(due - monotonic_now());
  }

 private:
  double pace_;
  bool started_ = false;
  Time wall_start_{};
  Time run_start_{};
};

void record_tick(RunLogWriter& writer, const ReplayRun& run) {
  writer.write_tick(run.input());
  for (const Outbox::Message& message : run.outbox().messages()) {
    writer.write_published(message.channel, message.utime_us, message.bytes);
  }
  writer.flush();
}

void show_progress(const ReplayRun& run, std::uint64_t ticks, Time began, bool last) {
  if (isatty(STDERR_FILENO) == 0 && !last) return;
  const double speed = to_seconds(monotonic_now() - began);
  fmt::print(stderr, "\rreplay {:3.0f} %  {} ticks  {:.0f} ticks/s{}", 100.0 * run.source().progress(), ticks,
             speed > 0.0 ? static_cast<double>(ticks) / speed : 0.0, last ? "\n" : "");
}

void tell_losses(const ReplayLosses& losses) {
  for (const LogDamage& damage : losses.damage) {
    say(Severity::warning, "damage at byte {}: {}; skipped", damage.offset, damage.reason);
  }
  if (losses.incomplete_ticks + losses.unrecorded_ticks > 0) {
    say(Severity::warning, "{} ticks were incomplete, {} were never recorded", losses.incomplete_ticks,
        losses.unrecorded_ticks);
  }
}

}  // namespace

ReplayRun::ReplayRun(const std::string& log, std::optional<Configuration> configuration, bool recover,
                     std::vector<FaultSpec> faults)
    : pool_(kFramesInFlight, 0, 0) {
  ReplayOptions options;
  options.recover = recover;
  if (configuration) options.tick_period = from_seconds(1.0 / configuration->robot.loop_rate_hz);
  source_ = std::make_unique<ReplaySource>(log, pool_, decode, options);
  const RunHeader header = required_header(*source_, log);
  configuration_ = chosen(header, configuration);
  materials_ = completed(header, configuration_);
  const RobotSetup setup = make_setup(configuration_, materials_, log);
  camera_ = setup.camera;
  robot_ = std::make_unique<Robot>(setup);
  if (!source_->recorded_ticks() || !faults.empty()) reflex_.emplace(configuration_);
  if (!faults.empty()) faults_.emplace(std::move(faults));
  input_.reserve();
}

bool ReplayRun::step() {
  if (!source_->next(input_, &recorded_)) return false;
  if (faults_) faults_->inject(input_);
  if (reflex_) {
    reflex_->run_up_to(input_);
    input_.timing = timing_;
  }
  const Time began = monotonic_now();
  outbox_.clear();
  decision_ = robot_->step(input_, outbox_);
  timing_.step_duration = monotonic_now() - began;
  if (reflex_) reflex_->decide(decision_);
  return true;
}

int run_replay(const ReplayJob& job, const std::function<bool()>& stop) {
  std::optional<Configuration> configuration;
  if (!job.configuration_files.empty()) configuration = load_configuration(job.configuration_files);
  ReplayRun run(job.log, configuration, job.recover, job.faults);
  std::optional<RunLogWriter> writer;
  if (!job.record.empty()) {
    RunHeader header = run.materials();
    header.ticks_recorded = true;
    writer.emplace(job.record);
    writer->write_header(header);
  }
  TelemetryParams telemetry = run.configuration().telemetry;
  if (job.pace <= 0.0) telemetry.lcm_url.clear();
  Publisher publisher(telemetry);
  Pacer pacer(job.pace);
  const Time began = monotonic_now();
  std::uint64_t ticks = 0;
  while (!stop() && run.step()) {
    pacer.wait_for(run.input().now);
    publisher.publish(run.outbox(), run.input().frame, monotonic_now(), run.input().utime_us);
    if (writer) record_tick(*writer, run);
    if (++ticks % 16 == 0) show_progress(run, ticks, began, false);
  }
  show_progress(run, ticks, began, true);
  tell_losses(run.source().losses());
  if (writer && !writer->close()) {
    throw FatalError(kExitIo, fmt::format("{}: cannot write the log: {}", job.record, std::strerror(writer->error_code())));
  }
  return kExitOk;
}

}  // namespace hindsight
