// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/eval_road_command.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "config/configuration.h"
#include "config/exit_code.h"
#include "perception/camera_model.h"
#include "perception/road_horizon.h"
#include "tools/builtin_config.h"
#include "tools/number_checks.h"
#include "tools/road_drawing.h"
#include "tools/road_evaluation.h"
#include "tools/road_picture.h"

namespace hindsight::tools {
namespace {

struct Options {
  std::string frames;
  std::string truth;
  std::string labels;
  std::string camera;
  std::string pictures;
  std::string method = "ours";
  std::vector<std::string> configuration_files;
  double rate_hz = 0.0;
  bool json = false;
};

Configuration configuration_of(const Options& options) {
  Configuration configuration = options.method == "thesis" ? thesis_configuration() : Configuration{};
  for (const std::string& file : options.configuration_files)
    read_configuration(configuration, ConfigDocument::load(file));
  return configuration;
}

double horizon_of(const Options& options) {
  if (options.camera.empty()) return std::numeric_limits<double>::quiet_NaN();
  return horizon_row_px(read_camera_model(options.camera));
}

nlohmann::ordered_json to_json(const RoadEvaluationResult& result) {
  return {{"pixel_coverage", result.score.pixel_coverage},
          {"line_coverage", result.score.line_coverage},
          {"mttf_frames", result.mttf_frames},
          {"ms_per_frame", result.ms_per_frame},
          {"frames", result.score.frames}};
}

void print_text(const Options& options, const RoadEvaluationResult& result) {
  const RoadScore& score = result.score;
  fmt::print("{}: pixel coverage {:.3f}, line coverage from near to far", options.method,
             score.pixel_coverage);
  for (const double line : score.line_coverage) fmt::print(" {:.3f}", line);
  fmt::print("\n{} frames scored, {} failures: {}{:.0f} frames to a failure; {:.2f} ms a frame\n",
             score.frames, score.failures, score.failures == 0 ? "at least " : "", result.mttf_frames,
             result.ms_per_frame);
}

void warn(const RoadEvaluationResult& result) {
  if (result.off_road_frames > 0)
    fmt::print(stderr, "eval road: the definition region is off the road in {} of {} scored frames\n",
               result.off_road_frames, result.score.frames);
  if (result.no_horizon_frames > 0)
    fmt::print(stderr, "eval road: no horizon in view in {} of {} scored frames\n", result.no_horizon_frames,
               result.score.frames);
  if (result.silent_frames > 0)
    fmt::print(stderr, "eval road: no road was told in {} of {} scored frames\n", result.silent_frames,
               result.score.frames);
}

RoadWatcher picture_writer(const Options& options) {
  if (options.pictures.empty()) return [](const auto&...) {};
  std::filesystem::create_directories(options.pictures);
  return [folder = std::filesystem::path(options.pictures)](const std::string& name, const cv::Mat& bgr,
                                                            const cv::Mat& truth, const cv::Mat& called,
                                                            const RoadMethod& method) {
    cv::Mat picture = draw_called_road(bgr, truth, called);
    const RoadFollower* follower = method.follower();
    if (follower != nullptr && follower->templates() != nullptr) draw_road(picture, *follower);
    cv::imwrite((folder / (name + ".jpg")).string(), picture);
  };
}

int eval_road(const Options& options) {
  RoadEvaluation evaluation;
  evaluation.frames = find_road_frames(options.frames);
  evaluation.rate_hz = options.rate_hz;
  evaluation.method = options.method;
  evaluation.configuration = configuration_of(options);
  evaluation.horizon_row_px = horizon_of(options);
  const RoadTruth truth(options.truth, evaluation.frames, options.labels);
  const RoadEvaluationResult result =
      evaluate_road(evaluation, truth, picture_writer(options), [&](std::size_t done) {
        if (done % 20 == 0) fmt::print(stderr, "\rroad: frame {} of {}", done, evaluation.frames.size());
      });
  fmt::print(stderr, "\r{:40}\r", "");
  warn(result);
  if (options.json) {
    fmt::print("{}\n", to_json(result).dump());
  } else {
    print_text(options, result);
  }
  return kExitOk;
}

}  // namespace

void add_eval_road(CLI::App& eval, Run& run) {
  auto options = std::make_shared<Options>();
  CLI::App* app =
      eval.add_subcommand("road", "how much of the road a method finds, on frames with truth (thesis 4.2)");
  app->add_option("--frames", options->frames,
                  "folder of consecutive pictures in the order of their names, or of folders with one each")
      ->required();
  app->add_option("--truth", options->truth,
                  "folder with label images named as the frames (NAME.png, NAME_L.png, NAME/labels.png), for "
                  "all or some "
                  "of them, or polygons.json; may be that of the frames")
      ->required();
  app->add_option("--rate", options->rate_hz, "frames a second [Hz]")->required()->check(above_zero());
  app->add_option("--method", options->method,
                  "ours: the default; thesis: its numbers; constant: the average road, no vision")
      ->capture_default_str()
      ->check(CLI::IsMember({"ours", "thesis", "mrf", "hsv", "texture", "constant"}));
  app->add_option("--labels", options->labels,
                  "table of the label images' colours (config/labels/*.toml show how); found by the colours "
                  "if not given")
      ->type_name("LABELS.toml");
  app->add_option("--camera", options->camera, "calibration with mounting: tells the horizon")
      ->type_name("CAM.yaml");
  app->add_option("--config", options->configuration_files, "over the method's configuration");
  app->add_option("--pictures", options->pictures,
                  "folder for each scored frame with truth and road drawn in");
  app->add_flag(
      "--json", options->json,
      "print {\"pixel_coverage\", \"line_coverage\": [near ... far], \"mttf_frames\", \"ms_per_frame\", "
      "\"frames\"}");
  app->callback([options, &run] { run = [options] { return eval_road(*options); }; });
}

}  // namespace hindsight::tools
