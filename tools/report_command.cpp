// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <memory>

#include "config/exit_code.h"
#include "daemon/replay_run.h"
#include "daemon/run_setup.h"
#include "tools/report_gallery.h"
#include "tools/report_page.h"
#include "tools/report_video.h"

namespace hindsight::tools {
namespace {

struct ReportArguments {
  std::string log;
  std::string folder;
  std::vector<std::string> configuration_files;
  bool recover = false;
  bool video = false;
};

void show_progress(const ReplayRun& run, std::size_t ticks, bool last) {
  if (isatty(STDERR_FILENO) == 0) return;
  fmt::print(stderr, "\rreport {:3.0f} %  {} ticks{}", 100.0 * run.source().progress(), ticks,
             last ? "\n" : "");
}

int report(const ReportArguments& arguments) {
  std::optional<Configuration> configuration;
  if (!arguments.configuration_files.empty())
    configuration = load_configuration(arguments.configuration_files);
  ReplayRun run(arguments.log, configuration, arguments.recover);
  const ReportFolder folder(arguments.folder);
  Gallery gallery(folder);
  RunTrace trace;
  std::optional<ReportVideo> video;
  if (arguments.video)
    video.emplace((folder.path() / "drive").string(), run.configuration().robot.loop_rate_hz,
                  cv::Size(run.camera().width_px, run.camera().height_px));
  while (run.step()) {
    trace.add(run);
    if (video) video->look(run, trace);
    gallery.look(run, trace.ticks.back().time_s);
    if (trace.ticks.size() % 16 == 0) show_progress(run, trace.ticks.size(), false);
  }
  show_progress(run, trace.ticks.size(), true);
  const std::string film = video ? std::filesystem::path(video->path()).filename().string() : std::string();
  write_page(folder, arguments.log, run, trace, gallery, film);
  fmt::print("{}: {} ticks, {} frames, {} training events\n", (folder.path() / "index.html").string(),
             trace.ticks.size(), trace.frames, trace.events.size());
  return kExitOk;
}

}  // namespace

void add_report(CLI::App& app, Run& run) {
  auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command =
      app.add_subcommand("report", "Replay a run log and write a page with pictures of what happened");
  command->add_option("log", arguments->log, "Run log")->required()->type_name("RUN.lcm");
  command->add_option("-o,--output", arguments->folder, "Folder to write, its page is index.html")
      ->required()
      ->type_name("DIR");
  command->add_option("--config", arguments->configuration_files,
                      "Configuration instead of the log's own; an imported log has none");
  command->add_flag("--video", arguments->video, "Write a film of the run, too: the view beside the map");
  command->add_flag("--recover", arguments->recover, "Skip what is damaged in the log");
  command->callback([arguments, &run] { run = [arguments] { return report(*arguments); }; });
}

}  // namespace hindsight::tools
