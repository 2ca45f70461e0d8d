// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/demo_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <memory>
#include <string>

#include "config/exit_code.h"
#include "daemon/run_setup.h"
#include "drivers/monotonic_clock.h"
#include "sim_replay/run_log_writer.h"
#include "tools/demo_run.h"

namespace hindsight::tools {
namespace {

struct DemoArguments {
  std::string output = "out";
  std::uint64_t seed = 3;
  double seconds = 60.0;
  std::vector<std::string> configuration_files;
};

void show_progress(const DemoSummary& now, Time began, bool last) {
  if (isatty(STDERR_FILENO) == 0 && !last) return;
  const double took_s = to_seconds(monotonic_now() - began);
  fmt::print(stderr, "\rdemo {:5.1f} m to the goal  {} touches  {} ticks  {:.1f} x real time {}",
             now.to_goal_m, now.touches, now.ticks, took_s > 0.0 ? now.seconds / took_s : 0.0,
             last ? "\n" : "");
}

void tell(const DemoSummary& summary, const std::string& log) {
  fmt::print(
      "{} after {:.1f} s, {:.1f} m from the goal: {} touches, {} components learnt, {:.2f} m of drift\n",
      summary.reached ? "Goal reached" : "Goal not reached", summary.seconds, summary.to_goal_m,
      summary.touches, summary.components_learnt, summary.drift_m);
  fmt::print("Run log: {}\n", log);
}

int demo(const DemoArguments& arguments) {
  std::filesystem::create_directories(arguments.output);
  const std::string log = (std::filesystem::path(arguments.output) / "demo.lcm").string();
  DemoRun run(load_configuration(arguments.configuration_files), arguments.seed);
  RunLogWriter writer(log);
  writer.write_header(run.materials());
  const Time began = monotonic_now();
  DemoSummary summary;
  while (!summary.reached && summary.seconds < arguments.seconds) {
    run.step();
    run.record(writer);
    summary = run.summary();
    show_progress(summary, began, false);
  }
  show_progress(summary, began, true);
  if (!writer.close()) {
    throw FatalError(kExitIo,
                     fmt::format("{}: cannot write the log: {}", log, std::strerror(writer.error_code())));
  }
  tell(summary, log);
  return kExitOk;
}

}  // namespace

void add_demo(CLI::App& app, Run& run) {
  auto arguments = std::make_shared<DemoArguments>();
  CLI::App* command =
      app.add_subcommand("demo", "Let a robot of its own drive through a synthetic grove; record the run");
  command->add_option("-o,--output", arguments->output, "Folder for the run log, demo.lcm")
      ->capture_default_str();
  command->add_option("--seed", arguments->seed, "Another number, another grove")->capture_default_str();
  command->add_option("--seconds", arguments->seconds, "Longest run, in the world's time [s]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command->add_option("--config", arguments->configuration_files, "The robot's configuration");
  command->callback([arguments, &run] { run = [arguments] { return demo(*arguments); }; });
}

}  // namespace hindsight::tools
