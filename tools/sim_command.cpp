// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/sim_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "config/exit_code.h"
#include "daemon/run_setup.h"
#include "drivers/monotonic_clock.h"
#include "sim_replay/run_log_writer.h"
#include "sim_replay/world/course.h"
#include "tools/number_checks.h"
#include "tools/sim_devices.h"
#include "tools/sim_run.h"

namespace hindsight::tools {
namespace {

struct SimArguments {
  std::string course;
  std::uint64_t seed = 1;
  double seconds = 600.0;
  double pace = 0.0;
  std::string record;
  bool devices = false;
  std::vector<std::string> configuration_files;
};

void show_progress(const SimSummary& now, Time began, bool last) {
  if (isatty(STDERR_FILENO) == 0 && !last) return;
  const double took_s = to_seconds(monotonic_now() - began);
  fmt::print(stderr, "\rsim {:5.1f} m to the goal  {} bumper, {} IR touches  {:.0f} s  {:.1f} x real time {}",
             now.to_goal_m, now.touches, now.ir_touches, now.seconds,
             took_s > 0.0 ? now.seconds / took_s : 0.0, last ? "\n" : "");
}

void tell(const SimSummary& s) {
  fmt::print(
      "{} after {:.1f} s and {:.1f} m, {:.1f} m from the goal: {} bumper touches, {} IR touches, {} lessons, "
      "{:.2f} m of "
      "drift\n",
      s.reached ? "Goal reached" : "Goal not reached", s.seconds, s.distance_m, s.to_goal_m, s.touches,
      s.ir_touches, s.lessons, s.drift_m);
}

/// Waits until the world's time has come; as fast as it goes where pace is 0.
void keep_pace(const SimSummary& now, Time began, double pace) {
  if (pace <= 0.0) return;
  const Time ahead = from_seconds(now.seconds / pace) - (monotonic_now() - began);
  if (ahead > Time{}) std::this_thread::sleep_for(ahead);
}

void close(RunLogWriter& writer, const std::string& path) {
  if (writer.close()) return;
  throw FatalError(kExitIo,
                   fmt::format("{}: cannot write the log: {}", path, std::strerror(writer.error_code())));
}

int sim_in_lock_step(const SimArguments& arguments, const World& world) {
  SimRun run({.configuration = load_configuration(arguments.configuration_files),
              .world = world,
              .seed = arguments.seed,
              .mixture = {}});
  std::optional<RunLogWriter> writer;
  if (!arguments.record.empty()) writer.emplace(arguments.record).write_header(run.materials());
  const Time began = monotonic_now();
  SimSummary summary;
  while (!summary.reached && summary.seconds < arguments.seconds) {
    run.step();
    if (writer) run.record(*writer);
    summary = run.summary();
    show_progress(summary, began, false);
    keep_pace(summary, began, arguments.pace);
  }
  show_progress(summary, began, true);
  if (writer) close(*writer, arguments.record);
  tell(summary);
  if (writer) fmt::print("Run log: {}\n", arguments.record);
  return kExitOk;
}

std::atomic<bool> interrupted = false;

void tell_devices(const DevicesSummary& s) {
  fmt::print(
      "{:.0f} s: {:.1f} m to the goal, {:.1f} m driven, {} bumper, {} IR touches, {} commands, {} frames\n",
      s.seconds, s.to_goal_m, s.distance_m, s.touches, s.ir_touches, s.commands, s.frames);
  std::fflush(stdout);
}

/// The goal in the robot's own world, for the operator: nobody else gives orders here.
void tell_goal(const World& world) {
  const Point2 goal_W = in_robots_world(world, world.goal);
  fmt::print("The goal lies at {:.2f} {:.2f}: hindsight send arm; hindsight send go-to {:.2f} {:.2f}\n",
             goal_W.x_m, goal_W.y_m, goal_W.x_m, goal_W.y_m);
}

int sim_on_devices(const SimArguments& arguments, const World& world) {
  std::signal(SIGINT, [](int) { interrupted = true; });
  std::signal(SIGTERM, [](int) { interrupted = true; });
  tell_goal(world);
  tell_devices(run_on_devices({.configuration = load_configuration(arguments.configuration_files),
                               .world = world,
                               .seed = arguments.seed,
                               .seconds = arguments.seconds},
                              interrupted, tell_devices));
  return kExitOk;
}

int sim(const SimArguments& arguments) {
  const World world = build_world(load_course(arguments.course), arguments.seed);
  return arguments.devices ? sim_on_devices(arguments, world) : sim_in_lock_step(arguments, world);
}

}  // namespace

void add_sim(CLI::App& app, Run& run) {
  auto arguments = std::make_shared<SimArguments>();
  CLI::App* command = app.add_subcommand("sim", "Let a robot drive a simulated course");
  command->add_option("course", arguments->course, "Course file")->required()->type_name("COURSE.toml");
  command->add_option("--seed", arguments->seed, "Another number, another world and other noise")
      ->capture_default_str();
  command->add_option("--seconds", arguments->seconds, "Longest run, in the world's time [s]")
      ->capture_default_str()
      ->check(above_zero());
  CLI::Option* config =
      command->add_option("--config", arguments->configuration_files, "The robot's configuration");
  CLI::Option* record =
      command->add_option("--record", arguments->record, "Run log to write")->type_name("RUN.lcm");
  CLI::Option* pace =
      command->add_option("--pace", arguments->pace, "Times real time; as fast as it goes by default")
          ->check(above_zero());
  command
      ->add_flag(
          "--devices", arguments->devices,
          "Be the world of a running hindsightd: at the other end of the v4l2loopback device, CAN bus, "
          "gpio-sim lines and gpsd port that its configuration names; goes by the clock")
      ->excludes(record)
      ->excludes(pace)
      ->needs(config);
  command->callback([arguments, &run] { run = [arguments] { return sim(*arguments); }; });
}

}  // namespace hindsight::tools
