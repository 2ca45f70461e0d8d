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
#include "tools/slip_camera.h"
#include "tools/slip_drive.h"
#include "tools/statistics.h"

namespace hindsight::tools {
namespace {

constexpr double kDrive_s = 300.0;
constexpr int kMostDrives = 1000;
constexpr std::uint64_t kOtherSeeds = 100'000;  ///< so that what is fed comes from other drives
constexpr double kSoon_s = 1.0, kLater_s = 2.0;
constexpr Time kLookBefore = from_seconds(1.0), kLookAfter = from_seconds(2.5);
constexpr double kFewFalseAlarms_perh = 1.0;
/// The first of slip_arms(); the others only vary the currents' window.
constexpr std::size_t kNamedArms = 4;
constexpr std::array kOrdinary{"grass", "leaf_litter", "soil", "mulch", "road", "gravel"};

/// A way to tell slip, over thresholds: of a component over DC, or of the way lost where it is told by the
/// ground.
struct SlipArm {
  std::string name;
  SlipWatchParams params;
  bool fed = false;  ///< false alarms: false, where the ground was rendered; true, on all the other drives

  bool by_ground() const { return params.ground.enabled; }
  double& threshold() { return by_ground() ? params.ground.lost_way_m : params.currents.threshold; }
  std::vector<double> thresholds() const;
};

/// What was driven.
struct SlipDrives {
  std::vector<SlipTrace> mud;       ///< rendered around each slip that is asked for
  std::vector<SlipTrace> seen;      ///< on each kind of ordinary ground, rendered
  std::vector<SlipTrace> ordinary;  ///< on ordinary ground, fed with the errors of those
};

/// What one arm does with one threshold.
struct Result {
  double threshold = 0.0;
  bool as_it_is = false;  ///< the arm's own threshold
  SlipScore score;
  double recorded_perh = 0.0;
};

std::vector<SlipArm> slip_arms() {
  GroundSlipParams blind;
  blind.enabled = false;
  std::vector<SlipArm> arms{{"default, ground rendered", {}},
                            {"default, ground fed", {}, true},
                            {"default, currents alone", {{}, blind}, true},
                            {"thesis", {thesis_configuration().slip, blind}, true}};
  const auto add = [&](const char* window, double window_s, double noise) {
    SlipDetectorParams params;
    params.window = window;
    params.window_s = window_s;
    params.noise_probability = noise;
    arms.push_back({fmt::format("{} {:.1f} s, noise {:g}", window, window_s, noise), {params, blind}, true});
  };
  for (const double window_s : {1.5, 1.2, 1.0, 0.7})
    add("hann", window_s, SlipDetectorParams{}.noise_probability);
  for (const double window_s : {1.0, 0.7}) add("hann", window_s, 1e-4);
  for (const double window_s : {1.5, 1.2, 1.0})
    add("rectangular", window_s, SlipDetectorParams{}.noise_probability);
  return arms;
}

std::vector<double> SlipArm::thresholds() const {
  if (by_ground()) return {0.005, 0.01, 0.02, 0.03, 0.04, 0.06, 0.08, 0.1, 0.15, 0.2, 0.3, 0.5};
  std::vector<double> all;
  for (int i = 2; i <= 12; ++i) all.push_back(0.05 * i);
  return all;
}

/// What is looked at around each slip that is asked for.
std::vector<SlipSpan> times_of_slips(const SlipTrace& trace) {
  std::vector<SlipSpan> times;
  for (const SlipSpan& slip : trace.fresh_slips()) {
    if (to_seconds(slip.end - slip.begin) >= kSoon_s)
      times.push_back({slip.begin - kLookBefore, slip.begin + kLookAfter});
  }
  return times;
}

std::vector<SlipTrace> drive_through_mud(const SlipExperiment& experiment, const Course& course) {
  const Configuration configuration;
  std::vector<SlipTrace> traces;
  for (std::size_t slips = 0, drive = 0; slips < static_cast<std::size_t>(experiment.slips); ++drive) {
    if (drive == kMostDrives)
      throw FatalError(kExitBadData, course.file + ": too little on which wheels slip");
    const std::uint64_t seed = experiment.seed + drive;
    const World world = build_world(course, seed);
    traces.push_back(drive_for_slip(configuration, world, seed, kDrive_s));
    const std::vector<SlipSpan> times = times_of_slips(traces.back());
    slips += times.size();
    if (!times.empty()) look_at_ground(configuration, world, seed, times, traces.back());
    fmt::print(stderr, "\r{} drives, {} slips   ", traces.size(), slips);
  }
  return traces;
}

/// Drive `number` on ordinary ground: kinds of ground take turns.
World ordinary_world(Course course, std::size_t number, std::uint64_t seed) {
  course.mud.patches = 0;
  course.course.ground = kOrdinary[number % kOrdinary.size()];
  return build_world(course, seed);
}

std::vector<SlipTrace> see_ordinary_ground(const SlipExperiment& experiment, const Course& course) {
  const Configuration configuration;
  const double each_s = experiment.seen_hours * 3600.0 / static_cast<double>(kOrdinary.size());
  std::vector<SlipTrace> traces;
  while (traces.size() < kOrdinary.size()) {
    const std::uint64_t seed = experiment.seed + kOtherSeeds + traces.size();
    const World world = ordinary_world(course, traces.size(), seed);
    traces.push_back(drive_for_slip(configuration, world, seed, each_s));
    const std::array always{SlipSpan{traces.back().begin, traces.back().ticks.back().now}};
    look_at_ground(configuration, world, seed, always, traces.back());
    fmt::print(stderr, "\r{} of {} kinds of ground seen   ", traces.size(), kOrdinary.size());
  }
  return traces;
}

std::vector<SlipTrace> drive_on_ordinary_ground(const SlipExperiment& experiment, const Course& course,
                                                const std::vector<SlipTrace>& seen) {
  const auto driven_h = [](std::size_t drives) { return static_cast<double>(drives) * kDrive_s / 3600.0; };
  std::vector<SlipTrace> traces;
  while (driven_h(traces.size()) < experiment.hours) {
    const std::uint64_t seed = experiment.seed + traces.size();
    const World world = ordinary_world(course, traces.size(), seed);
    const std::vector<StepError> errors = step_errors(seen[traces.size() % seen.size()]);
    traces.push_back(drive_for_slip(Configuration{}, world, seed, kDrive_s));
    feed_steps(errors, seed, traces.back());
    fmt::print(stderr, "\r{:.1f} h on ordinary ground   ", driven_h(traces.size()));
  }
  return traces;
}

SlipDrives drive_all(const SlipExperiment& experiment, const Course& course) {
  SlipDrives drives{drive_through_mud(experiment, course), see_ordinary_ground(experiment, course), {}};
  drives.ordinary = drive_on_ordinary_ground(experiment, course, drives.seen);
  return drives;
}

/// Both in one: slips from the drives through mud, false alarms from those on ordinary ground.
SlipScore score_all(const SlipArm& arm, const SlipDrives& drives) {
  const double rate_hz = RobotParams{}.current_rate_hz, track_width_m = VehicleParams{}.track_width_m;
  SlipScore slips, alarms;
  for (const SlipTrace& trace : drives.mud) score_slip(arm.params, rate_hz, track_width_m, trace, slips);
  for (const SlipTrace& trace : arm.fed ? drives.ordinary : drives.seen)
    score_slip(arm.params, rate_hz, track_width_m, trace, alarms);
  alarms.slips = slips.slips;
  return alarms;
}

/// Nobody saw the ground there.
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

std::vector<Result> results_of(const SlipArm& arm, const SlipDrives& drives,
                               const std::vector<MotorRecording>& recordings, double rate_hz) {
  std::vector<Result> results;
  for (const double threshold : arm.thresholds()) {
    SlipArm with = arm;
    const bool as_it_is = std::abs(with.threshold() - threshold) < 1e-9;
    with.threshold() = threshold;
    results.push_back({threshold, as_it_is, score_all(with, drives),
                       recorded_per_hour(with.params.currents, recordings, rate_hz)});
  }
  return results;
}

std::vector<std::string> row(const std::string& name, const Result& result, bool recorded) {
  const SlipScore& score = result.score;
  return {name,
          fmt::format("{:.3g}", result.threshold),
          fmt::format("{:.1f} %", 100 * score.share_told_within(kSoon_s)),
          fmt::format("{:.1f} %", 100 * score.share_told_within(kLater_s)),
          in_seconds(score.delay_s(0.5, kSoon_s)),
          in_seconds(score.delay_s(0.95, kSoon_s)),
          fmt::format("{:.2f}", score.false_alarms_per_hour()),
          fmt::format("{:.2f}", score.quiet_h),
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
          {"false_alarms", score.false_alarms},
          {"false_alarms_per_hour", score.false_alarms_per_hour()},
          {"quiet_hours", score.quiet_h},
          {"recorded_per_hour", result.recorded_perh}};
}

/// How well the camera measures the way over the ground, step by step.
nlohmann::ordered_json json_of_steps(const std::vector<SlipTrace>& traces) {
  std::vector<double> errors_m;
  std::size_t steps = 0;
  for (const SlipTrace& trace : traces) {
    steps += trace.steps.size();
    for (const StepError& error : step_errors(trace)) {
      if (error.valid) errors_m.push_back(std::abs(error.forward_m));
    }
  }
  return {{"steps", steps},
          {"not_told", steps - errors_m.size()},
          {"median_error_m", quantile_of(errors_m, 0.5)},
          {"p95_error_m", quantile_of(errors_m, 0.95)},
          {"worst_error_m", quantile_of(errors_m, 1.0)}};
}

}  // namespace

int run_slip_experiment(const SlipExperiment& experiment) {
  const Course course = load_course(experiment.course);
  const ExperimentOutput output(experiment.folder, "slip");
  std::vector<MotorRecording> recordings;
  for (const std::string& file : experiment.recordings) recordings.push_back(read_motor_csv(file, {}));
  const SlipDrives drives = drive_all(experiment, course);
  ResultTable table{{"", "threshold", "told within 1 s", "told within 2 s", "median delay [s]",
                     "95 % delay [s]", "false alarms an hour", "of [h]", "recordings: alarms an hour"},
                    {}};
  PngChart chart("Slips told within 1 s against false alarms, over thresholds",
                 {0.1, 10000.0, "false alarms an hour (0.1: none)", true},
                 {0.0, 1.0, "share told within 1 s"});
  nlohmann::ordered_json json;
  const std::vector<SlipArm> arms = slip_arms();
  for (std::size_t a = 0; a < arms.size(); ++a) {
    const std::vector<Result> results = results_of(arms[a], drives, recordings, experiment.recordings_hz);
    std::vector<cv::Point2d> points;
    for (const Result& result : results) {
      points.emplace_back(result.score.false_alarms_per_hour(), result.score.share_told_within(kSoon_s));
      json["arms"][arms[a].name].push_back(json_of(result));
      if (a < kNamedArms && result.as_it_is)
        table.rows.push_back(row(arms[a].name + ", as it is", result, !recordings.empty()));
    }
    if (const Result* quiet = quiet_one(results))
      table.rows.push_back(row(arms[a].name, *quiet, !recordings.empty()));
    chart.line(points, color_of_line(a), arms[a].name);
    fmt::print(stderr, "\rarm {} of {}   ", a + 1, arms.size());
    json["slips_of_1_s"] = results[0].score.lasted(kSoon_s);
    json["slips_of_2_s"] = results[0].score.lasted(kLater_s);
  }
  json["steps_at_slips"] = json_of_steps(drives.mud);
  json["steps_on_ordinary_ground"] = json_of_steps(drives.seen);
  cv::imwrite(output.path(".png"), chart.picture());
  output.write(json, table.markdown());
  fmt::print(stderr, "\n");
  fmt::print("{}", table.markdown());
  return kExitOk;
}

}  // namespace hindsight::tools
