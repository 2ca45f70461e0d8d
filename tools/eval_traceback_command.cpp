// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/eval_traceback_command.h"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>

#include "config/exit_code.h"
#include "tools/builtin_config.h"
#include "tools/traceback_evaluation.h"

namespace hindsight::tools {
namespace {

constexpr int kMinFrames[] = {10, 30, 50, 100};

struct Options {
  std::string frames;
  bool json = false;
};

std::vector<TracebackArm> make_arms(cv::Size size) {
  std::vector<TracebackArm> arms;
  const Configuration thesis = thesis_configuration();
  arms.push_back(hindsight_arm("thesis", thesis.flow, thesis.flow_history, size));
  arms.push_back(opencv_arm("thesis_opencv", thesis.flow, thesis.flow_history, size));
  arms.push_back(hindsight_arm("default", {}, {}, size));
  return arms;
}

nlohmann::ordered_json to_json(const TracebackSummary& summary) {
  if (summary.tracks == 0) return {{"median_px", nullptr}, {"p75_px", nullptr}, {"tracks", 0}};
  return {{"median_px", summary.median_px}, {"p75_px", summary.p75_px}, {"tracks", summary.tracks}};
}

void print_json(std::span<const TracebackArm> arms) {
  nlohmann::ordered_json all;
  for (const auto& arm : arms) {
    for (const int frames : kMinFrames)
      all[arm.name][std::to_string(frames)] = to_json(summarise(arm.errors, frames));
  }
  fmt::print("{}\n", all.dump(2));
}

void print_table(std::span<const TracebackArm> arms) {
  fmt::print(
      "traceback error in pixels, median / upper quartile (tracks), for tracks of at least so many frames\n");
  fmt::print("that end in the image rows below 45 % of its height\n\n{:<14}", "");
  for (const int frames : kMinFrames) fmt::print("{:>22}", frames);
  for (const auto& arm : arms) {
    fmt::print("\n{:<14}", arm.name);
    for (const int frames : kMinFrames) {
      const TracebackSummary s = summarise(arm.errors, frames);
      fmt::print("{:>22}",
                 s.tracks == 0 ? "-" : fmt::format("{:.1f} / {:.1f} ({})", s.median_px, s.p75_px, s.tracks));
    }
  }
  fmt::print("\n");
}

int evaluate(const Options& options) {
  cv::setNumThreads(1);
  ImageFolder frames(options.frames);
  std::vector<TracebackArm> arms = make_arms(frames.read(0).size());
  evaluate_traceback(frames, arms, [&](int done) {
    std::fprintf(stderr, "\rtraceback: frame %d of %d", done, frames.size());
    if (done == frames.size()) std::fprintf(stderr, "\n");
  });
  options.json ? print_json(arms) : print_table(arms);
  return kExitOk;
}

}  // namespace

void add_eval_traceback(CLI::App& eval, Run& run) {
  auto options = std::make_shared<Options>();
  CLI::App* app =
      eval.add_subcommand("traceback", "error of the grid traceback against long full-resolution tracks");
  app->add_option("--frames", options->frames,
                  "folder of consecutive .jpg or .png frames, in the order of their names")
      ->required();
  app->add_flag("--json", options->json, "print JSON: configuration, least track length, errors in pixels");
  app->callback([options, &run] { run = [options] { return evaluate(*options); }; });
}

}  // namespace hindsight::tools
