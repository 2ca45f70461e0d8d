// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/eval_slip_command.h"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "config/exit_code.h"
#include "perception/slip_detector.h"
#include "tools/motor_csv.h"
#include "tools/number_checks.h"
#include "tools/slip_score.h"

namespace hindsight::tools {
namespace {

struct Options {
  std::vector<std::string> files;
  std::vector<std::string> columns;
  double rate_hz = 0.0;
  bool json = false;
};

struct Tally {
  std::size_t samples = 0;
  int detections = 0;
};

SlipDetectorParams thesis_params() {
  SlipDetectorParams params;
  params.half_width_hz = 0.5;
  params.window = "rectangular";
  params.local_peak = false;
  params.noise_probability = 1.0;
  params.min_dc_a = params.min_speed_mps = params.hold_s = 0.0;
  return params;
}

nlohmann::ordered_json figures(const Tally& tally, double rate_hz) {
  const double hours = static_cast<double>(tally.samples) / rate_hz / 3600.0;
  return {{"hours", hours}, {"detections", tally.detections}, {"per_hour", tally.detections / hours}};
}

int eval_slip(const Options& options) {
  if (options.columns.size() == 3) {
    throw FatalError(kExitUsage,
                     "--columns: got three names; expected two currents, or two currents and two speeds");
  }
  Tally by_default, by_thesis;
  const auto add = [&](Tally& sum, const MotorRecording& recording, const SlipDetectorParams& params) {
    sum.samples += recording.samples.size();
    sum.detections += count_detections(recording, options.rate_hz, params);
  };
  for (const std::string& file : options.files) {
    const MotorRecording recording = read_motor_csv(file, options.columns);
    add(by_default, recording, SlipDetectorParams{});
    add(by_thesis, recording, thesis_params());
  }
  nlohmann::ordered_json result = figures(by_default, options.rate_hz);
  result["thesis"] = figures(by_thesis, options.rate_hz);
  if (options.json) {
    std::puts(result.dump().c_str());
    return kExitOk;
  }
  const auto print = [](const char* name, const nlohmann::ordered_json& part) {
    fmt::print("{:8} {:8.3f} h {:6} detections {:8.1f} per hour\n", name, part["hours"].get<double>(),
               part["detections"].get<int>(), part["per_hour"].get<double>());
  };
  print("default", result);
  print("thesis", result["thesis"]);
  return kExitOk;
}

}  // namespace

void add_eval_slip(CLI::App& eval, Run& run) {
  CLI::App& slip =
      *eval.add_subcommand("slip", "how often the slip detector speaks on recorded motor currents");
  const auto options = std::make_shared<Options>();
  slip.add_option("--csv", options->files, "recordings, each with a line of column names")->required();
  slip.add_option("--rate", options->rate_hz, "samples a second [Hz]")->required()->check(above_zero());
  slip.add_option("--columns", options->columns,
                  "names of the columns: left and right current [A], then left and right wheel speed [m/s]; "
                  "found by name if not given")
      ->delimiter(',')
      ->expected(2, 4);
  slip.add_flag("--json", options->json,
                "print {\"hours\", \"detections\", \"per_hour\", \"thesis\": {...}}");
  slip.callback([options, &run] { run = [options] { return eval_slip(*options); }; });
}

}  // namespace hindsight::tools
