// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/experiment_slip.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <optional>

#include "config/exit_code.h"
#include "sim_replay/world/course.h"
#include "tools/builtin_config.h"
#include "tools/experiment_output.h"
#include "tools/png_chart.h"
#include "tools/slip_drive.h"

namespace hindsight::tools {
namespace {

constexpr double kDrive_s = 300.0;
constexpr int kMostDrives = 1000;
constexpr double kSoon_s = 1.0, kLater_s = 2.0;
constexpr double kFewFalseAlarms_perh = 1.0;
constexpr std::array kOrdinary{"grass", "leaf_litter", "soil", "mulch", "road", "gravel"};

struct SlipArm {
  std::string name;
  SlipDetectorParams params;
};

/// What one arm does with one threshold.
struct Result {
  double threshold = 0.0;
  SlipScore score;
  double recorded_perh = 0.0;
};

std::vector<SlipArm> slip_arms() {
  std::vector<SlipArm> arms{{"thesis", thesis_configuration().slip}, {"default", SlipDetectorParams{}}};
  const auto add = [&](const char* window, double window_s, double noise) {
    SlipDetectorParams params;
    params.window = window;
    params.window_s = window_s;
    params.noise_probability = noise;
    arms.push_back({fmt::format("{} {:.1f} s, noise {:g}", window, window_s, noise), params});
  };
  for (const double window_s : {1.5, 1.2, 1.0, 0.7})
    add("hann", window_s, SlipDetectorParams{}.noise_probability);
  for (const double window_s : {1.0, 0.7}) add("hann", window_s, 1e-4);
  for (const double window_s : {1.5, 1.2, 1.0})
    add("rectangular", window_s, SlipDetectorParams{}.noise_probability);
  return arms;
}

std::vector<double> thresholds() {
  std::vector<double> all;
  for (int i = 2; i <= 12; ++i) all.push_back(0.05 * i);
  return all;
}

std::vector<SlipTrace> drive_through_mud(const SlipExperiment& experiment, const Course& course) {
  std::vector<SlipTrace> traces;
  for (int slips = 0, drive = 0; slips < experiment.slips; ++drive) {
    if (drive == kMostDrives)
      throw FatalError(kExitBadData, course.file + ": too little on which wheels slip");
    const std::uint64_t seed = experiment.seed + static_cast<unsigned>(drive);
    traces.push_back(drive_for_slip(Configuration{}, build_world(course, seed), seed, kDrive_s));
    SlipScore score;
    score_slip(SlipDetectorParams{}, RobotParams{}.current_rate_hz, traces.back(), score);
    slips += score.lasted(kSoon_s);
    fmt::print(stderr, "\r{} drives, {} slips   ", traces.size(), slips);
  }
  return traces;
}

std::vector<SlipTrace> drive_on_ordinary_ground(const SlipExperiment& experiment, Course course) {
  std::vector<SlipTrace> traces;
  course.mud.patches = 0;
  while (static_cast<double>(traces.size()) * kDrive_s < experiment.hours * 3600.0) {
    const std::uint64_t seed = experiment.seed + traces.size();
    course.course.ground = kOrdinary[traces.size() % kOrdinary.size()];
    traces.push_back(drive_for_slip(Configuration{}, build_world(course, seed), seed, kDrive_s));
    fmt::print(stderr, "\r{:.1f} h on ordinary ground   ",
               static_cast<double>(traces.size()) * kDrive_s / 3600.0);
  }
  return traces;
}

/// Both in one: slips from the drives through mud, false alarms from those on ordinary ground.
SlipScore score_all(const SlipDetectorParams& params, const std::vector<SlipTrace>& mud,
                    const std::vector<SlipTrace>& ordinary) {
  SlipScore slips, alarms;
  for (const SlipTrace& trace : mud) score_slip(params, RobotParams{}.current_rate_hz, trace, slips);
  for (const SlipTrace& trace : ordinary) score_slip(params, RobotParams{}.current_rate_hz, trace, alarms);
  alarms.slips = slips.slips;
  return alarms;
}

double recorded_per_hour(const SlipDetectorParams& params, const std::vector<MotorRecording>& recordings,
                         double rate_hz) {
  int detections = 0;
  double hours = 0.0;
  for (const MotorRecording& recording : recordings) {
    detections += count_detections(recording, rate_hz, params);
    hours += static_cast<double>(recording.samples.size()) / rate_hz / 3600.0;
  }
  return hours > 0.0 ? detections / hours : 0.0;
}

/// The lowest threshold with few false alarms.
const Result* quiet_one(const std::vector<Result>& results) {
  for (const Result& result : results) {
    if (result.score.false_alarms_per_hour() < kFewFalseAlarms_perh) return &result;
  }
  return nullptr;
}

std::string in_seconds(double s) { return std::isfinite(s) ? fmt::format("{:.2f}", s) : "never"; }

std::vector<std::string> row(const std::string& name, const Result& result, bool recorded) {
  const SlipScore& score = result.score;
  return {name,
          fmt::format("{:.2f}", result.threshold),
          fmt::format("{:.1f} %", 100 * score.share_told_within(kSoon_s)),
          fmt::format("{:.1f} %", 100 * score.share_told_within(kLater_s)),
          in_seconds(score.delay_s(0.5, kSoon_s)),
          in_seconds(score.delay_s(0.95, kSoon_s)),
          fmt::format("{:.2f}", score.false_alarms_per_hour()),
          recorded ? fmt::format("{:.1f}", result.recorded_perh) : "-"};
}

nlohmann::ordered_json json_of(const Result& result) {
  const auto finite = [](double s) {
    return std::isfinite(s) ? nlohmann::ordered_json(s) : nlohmann::ordered_json(nullptr);
  };
  const SlipScore& score = result.score;
  return {{"threshold", result.threshold},
          {"told_within_1_s", score.share_told_within(kSoon_s)},
          {"told_within_2_s", score.share_told_within(kLater_s)},
          {"median_delay_s", finite(score.delay_s(0.5, kSoon_s))},
          {"p95_delay_s", finite(score.delay_s(0.95, kSoon_s))},
          {"false_alarms_per_hour", score.false_alarms_per_hour()},
          {"recorded_per_hour", result.recorded_perh}};
}

}  // namespace

int run_slip_experiment(const SlipExperiment& experiment) {
  const Course course = load_course(experiment.course);
  const ExperimentOutput output(experiment.folder, "slip");
  std::vector<MotorRecording> recordings;
  for (const std::string& file : experiment.recordings) recordings.push_back(read_motor_csv(file, {}));
  const std::vector<SlipTrace> mud = drive_through_mud(experiment, course),
                               ordinary = drive_on_ordinary_ground(experiment, course);
  ResultTable table{{"", "threshold", "told within 1 s", "told within 2 s", "median delay [s]",
                     "95 % delay [s]", "false alarms an hour", "recordings: alarms an hour"},
                    {}};
  PngChart chart("Slips told within 1 s against false alarms; thresholds 0.10 to 0.60",
                 {0.1, 10000.0, "false alarms an hour (0.1: none)", true},
                 {0.0, 1.0, "share told within 1 s"});
  nlohmann::ordered_json json;
  const std::vector<SlipArm> arms = slip_arms();
  for (std::size_t a = 0; a < arms.size(); ++a) {
    std::vector<Result> results;
    std::vector<cv::Point2d> points;
    for (const double threshold : thresholds()) {
      SlipDetectorParams params = arms[a].params;
      params.threshold = threshold;
      results.push_back({threshold, score_all(params, mud, ordinary),
                         recorded_per_hour(params, recordings, experiment.recordings_hz)});
      points.emplace_back(results.back().score.false_alarms_per_hour(),
                          results.back().score.share_told_within(kSoon_s));
      json["arms"][arms[a].name].push_back(json_of(results.back()));
    }
    if (a < 2) table.rows.push_back(row(arms[a].name + " as it is", results[3], !recordings.empty()));
    if (const Result* quiet = quiet_one(results))
      table.rows.push_back(row(arms[a].name, *quiet, !recordings.empty()));
    chart.line(points, color_of_line(a), arms[a].name);
    fmt::print(stderr, "\rarm {} of {}   ", a + 1, arms.size());
    json["slips_of_1_s"] = results[0].score.lasted(kSoon_s),
    json["slips_of_2_s"] = results[0].score.lasted(kLater_s);
    json["quiet_hours"] = results[0].score.quiet_h;
  }
  cv::imwrite(output.path(".png"), chart.picture());
  output.write(json, table.markdown());
  fmt::print(stderr, "\n");
  fmt::print("{}", table.markdown());
  return kExitOk;
}

}  // namespace hindsight::tools
