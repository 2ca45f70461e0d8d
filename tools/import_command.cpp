// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/import_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <memory>

#include "config/exit_code.h"
#include "daemon/run_setup.h"
#include "tools/builtin_config.h"
#include "tools/number_checks.h"
#include "tools/track_can_encoder.h"

namespace hindsight::tools {
namespace {

struct ImportArguments {
  std::string frames;
  double rate_hz = 0.0;
  std::string camera;
  std::string track;
  std::string output;
  std::vector<std::string> configuration_files;
};

TrackCanEncoder encoder_for(const ImportArguments& arguments) {
  if (arguments.configuration_files.empty()) return {builtin_dbc(), "lagr.dbc", CanRolesParams{}};
  const Configuration configuration = load_configuration(arguments.configuration_files);
  return {load_materials(configuration).dbc, configuration.can_roles.dbc, configuration.can_roles};
}

void show(std::uint64_t done, std::uint64_t total) {
  if (isatty(STDERR_FILENO) == 0 && done != total) return;
  fmt::print(stderr, "\rimport {} of {} frames{}", done, total, done == total ? "\n" : "");
}

int import(const ImportArguments& arguments) {
  ImportOptions options;
  options.frames = arguments.frames;
  options.rate_hz = arguments.rate_hz;
  options.camera = arguments.camera;
  options.track = arguments.track;
  options.output = arguments.output;
  options.build_id = build_id();
  TrackCanEncoder encoder = encoder_for(arguments);
  const ImportSummary summary = import_recording(options, encoder, show);
  fmt::print(
      "{}: {} frames, {} track rows, {} CAN frames, {} edges, {} fixes, {} commands, {:.1f} s, {:.1f} MB\n",
      arguments.output, summary.frames, summary.rows, summary.can_frames, summary.edges, summary.fixes,
      summary.commands, summary.duration_s, static_cast<double>(summary.bytes) * 1e-6);
  return kExitOk;
}

constexpr const char* kColumns =
    "Columns of TRACK.csv, in any order, named in its first line; an empty cell is no sample:\n"
    "  time_s (required)            of the recording; the first frame is at 0 [s]\n"
    "  left_mps, right_mps          wheel speeds, forward positive [m/s]\n"
    "  left_a, right_a              motor currents [A]\n"
    "  ir_left_m, ir_right_m        infrared ranges [m]\n"
    "  yaw_rate_radps               gyro, counter-clockwise from above [rad/s]\n"
    "  bumper_left, bumper_right, estop   levels, 1 pressed, 0 not\n"
    "  latitude_deg, longitude_deg  GPS fix, WGS84 [deg]\n"
    "  goal_east_m, goal_north_m    the operator says: go there [m]\n"
    "  arm                          1: the operator arms; 0 after it: disarms";

}  // namespace

void add_import(CLI::App& app, Run& run) {
  auto arguments = std::make_shared<ImportArguments>();
  CLI::App* command =
      app.add_subcommand("import", "Make a run log of pictures or a video and a track of the other sensors");
  command->add_option("--frames", arguments->frames, "Folder of numbered pictures, or a video file")
      ->required();
  command->add_option("--rate", arguments->rate_hz, "Frames a second [Hz]")->required()->check(above_zero());
  command->add_option("--camera", arguments->camera, "Calibration, OpenCV's or ROS's YAML")->required();
  command->add_option("--track", arguments->track, "CSV with the other sensors' samples");
  command->add_option("--config", arguments->configuration_files,
                      "The vehicle's configuration, for its CAN protocol");
  command->add_option("-o,--output", arguments->output, "Run log to write")->required()->type_name("RUN.lcm");
  command->footer(kColumns);
  command->callback([arguments, &run] { run = [arguments] { return import(*arguments); }; });
}

}  // namespace hindsight::tools
