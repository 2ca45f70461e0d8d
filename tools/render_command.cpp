// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/render_command.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "config/exit_code.h"
#include "daemon/run_setup.h"
#include "sim_replay/world/course.h"
#include "tools/builtin_config.h"
#include "tools/cpu_time.h"
#include "tools/number_checks.h"
#include "tools/road_labels.h"
#include "tools/sim_feed.h"
#include "tools/sim_run.h"
#include "tools/trail_driver.h"

namespace hindsight::tools {
namespace {

namespace fs = std::filesystem;

struct RenderArguments {
  std::string course;
  std::string folder;
  std::uint64_t seed = 1;
  int frames = 7200;
  int truth_every = 10;
};

cv::Mat label_picture(const RenderedFrame& frame, cv::Size size) {
  cv::Mat picture(size, CV_8UC3);
  std::size_t i = 0;
  for (auto pixel = picture.begin<cv::Vec3b>(); pixel != picture.end<cv::Vec3b>(); ++pixel)
    *pixel = color_of(frame.labels[i++]);
  return picture;
}

void write(const fs::path& file, const void* bytes, std::size_t size) {
  std::ofstream out(file, std::ios::binary);
  out.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  out.close();
  if (!out) throw FatalError(kExitIo, file.string() + ": cannot be written");
}

void write_picture(const fs::path& file, const cv::Mat& picture) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(file.extension().string(), picture, bytes);
  write(file, bytes.data(), bytes.size());
}

void write_text(const fs::path& file, const std::string& text) { write(file, text.data(), text.size()); }

fs::path make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw FatalError(kExitIo, fmt::format("{}: cannot be made: {}", folder.string(), error.message()));
  return folder;
}

int render(const RenderArguments& arguments) {
  const World world = build_world(load_course(arguments.course), arguments.seed);
  const Configuration configuration;
  const RobotSetup setup = make_setup(configuration, sim_materials(configuration, {}), "simulation");
  const fs::path folder = make_folder(arguments.folder);
  const fs::path frames = make_folder(folder / "frames"), truth = make_folder(folder / "truth");
  SimFeed feed(setup, world, arguments.seed, false);
  TrailDriver driver(world, configuration.vehicle.track_width_m);
  write_text(folder / "camera.yaml", builtin_calibration());
  write_text(truth / "labels.toml", simulator_label_table());
  TickInput input;
  int frame = 0;
  double cpu_s = 0.0;
  for (; frame < arguments.frames && !driver.arrived(feed.vehicle()); ++frame) {
    const bool truth_due = frame % arguments.truth_every == 0;
    feed.keep_truth(truth_due);
    const double begin_s = process_cpu_s();
    feed.advance(input, [&](const TickInput&) { return driver.drive(feed.vehicle()); });
    cpu_s += process_cpu_s() - begin_s;
    const auto& jpeg = input.frame->bytes;
    write(frames / fmt::format("{:06}.jpg", frame), jpeg.data(), jpeg.size());
    if (truth_due) {
      write_picture(truth / fmt::format("{:06}.png", frame),
                    label_picture(feed.rendered(), {input.frame->width_px, input.frame->height_px}));
    }
    fmt::print(stderr, "\rrender: frame {} of {}", frame + 1, arguments.frames);
  }
  fmt::print(stderr, "\n");
  fmt::print("{} frames of {:.0f} m in {}; {:.1f} frames/s on one core\n", frame, feed.vehicle().distance_m(),
             folder.string(), frame / cpu_s);
  return kExitOk;
}

}  // namespace

void add_render(CLI::App& app, Run& run) {
  auto arguments = std::make_shared<RenderArguments>();
  CLI::App* command = app.add_subcommand(
      "render",
      "Drive along a simulated trail and write frames, their true labels and the camera's calibration");
  command->add_option("course", arguments->course, "Course file with a trail")
      ->required()
      ->type_name("COURSE.toml");
  command->add_option("-o,--output", arguments->folder, "Folder for frames/, truth/ and camera.yaml")
      ->required()
      ->type_name("DIR");
  command->add_option("--seed", arguments->seed, "Another number, another world and other noise")
      ->capture_default_str();
  command
      ->add_option("--frames", arguments->frames, "At most so many; the drive ends at the trail's end, too")
      ->capture_default_str()
      ->check(above_zero());
  command
      ->add_option("--truth-every", arguments->truth_every, "Of so many frames, one has its labels written")
      ->capture_default_str()
      ->check(above_zero());
  command->callback([arguments, &run] { run = [arguments] { return render(*arguments); }; });
}

}  // namespace hindsight::tools
