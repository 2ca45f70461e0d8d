// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/experiment_failsafe.h"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "config/exit_code.h"
#include "sim_replay/world/course.h"
#include "tools/experiment_output.h"
#include "tools/png_chart.h"
#include "tools/sim_run.h"
#include "tools/statistics.h"
#include "tools/stop_watch.h"

namespace hindsight::tools {
namespace {

constexpr double kSteady_s = 1.0;
constexpr double kWatched_s = 5.0;
constexpr double kDrawn_s = 2.5;

/// One fault in one drive.
struct Outcome {
  double speed_mps = 0.0;  ///< when it came
  std::optional<double> zero_s, stand_s;
  double rolled_m = 0.0;
  StopReason reason = StopReason::none;
  std::vector<cv::Point2d> speeds;  ///< over the time since
};

/// Until it has cruised for a while.
void get_under_way(SimRun& run, const FailsafeExperiment& experiment) {
  double steady_s = 0.0, last_s = 0.0;
  while (steady_s < kSteady_s) {
    run.step();
    const double now_s = run.summary().seconds;
    if (now_s > experiment.longest_s) {
      throw FatalError(kExitBadData,
                       fmt::format("{}: the robot is not at {} m/s for a second within {} s",
                                   experiment.course, experiment.cruise_mps, experiment.longest_s));
    }
    steady_s = run.feed().vehicle().speed_mps() >= experiment.cruise_mps ? steady_s + now_s - last_s : 0.0;
    last_s = now_s;
  }
}

Outcome drive(const FailsafeExperiment& experiment, const World& world, std::uint64_t seed, SimFault fault) {
  SimRun run({.configuration = {}, .world = world, .seed = seed, .mixture = {}});
  get_under_way(run, experiment);
  Outcome outcome;
  outcome.speed_mps = run.feed().vehicle().speed_mps();
  const Time began = run.input().now;
  StopWatch watch;
  watch.begin(began, run.feed().vehicle().distance_m());
  while (to_seconds(run.input().now - began) < kWatched_s) {
    run.step(fault, [&](Time now, const SimVehicle& vehicle, const std::optional<WheelCommand>& command) {
      watch.see(now, vehicle.speed_mps(), vehicle.distance_m(), command);
      outcome.speeds.emplace_back(to_seconds(now - began), vehicle.speed_mps());
    });
    // A dead process has no reasons.
    if (outcome.reason == StopReason::none && commands(fault))
      outcome.reason = static_cast<StopReason>(run.input().reflex.stop_reason);
  }
  outcome.zero_s = watch.to_zero_s();
  outcome.stand_s = watch.to_standstill_s();
  outcome.rolled_m = watch.rolled_m();
  return outcome;
}

/// The longest of all drives; "-" where one does not end.
std::string worst(const std::vector<Outcome>& outcomes, auto&& value) {
  double most = 0.0;
  for (const Outcome& outcome : outcomes) {
    const std::optional<double> v = value(outcome);
    if (!v) return "-";
    most = std::max(most, *v);
  }
  return fmt::format("{:.2f}", most);
}

std::vector<std::string> row(SimFault fault, const std::vector<Outcome>& outcomes) {
  const bool stops =
      std::all_of(outcomes.begin(), outcomes.end(), [](const Outcome& o) { return o.stand_s.has_value(); });
  std::vector<double> speeds;
  for (const Outcome& outcome : outcomes) speeds.push_back(outcome.speed_mps);
  return {name_of(fault),
          fmt::format("{:.2f}", mean_of(speeds)),
          worst(outcomes, [](const Outcome& o) { return o.zero_s; }),
          worst(outcomes, [](const Outcome& o) { return o.stand_s; }),
          stops ? worst(outcomes, [](const Outcome& o) { return std::optional(o.rolled_m); }) : "drives on",
          fault == SimFault::killed || fault == SimFault::bus_cut ? "base: no commands"
                                                                  : name_of(outcomes.front().reason)};
}

nlohmann::ordered_json json_of(const Outcome& outcome) {
  const auto number = [](const std::optional<double>& s) {
    return s ? nlohmann::ordered_json(*s) : nlohmann::ordered_json(nullptr);
  };
  return {{"speed_mps", outcome.speed_mps},
          {"to_zero_command_s", number(outcome.zero_s)},
          {"to_standstill_s", number(outcome.stand_s)},
          {"rolled_m", outcome.rolled_m},
          {"stop_reason", name_of(outcome.reason)}};
}

}  // namespace

int run_failsafe_experiment(const FailsafeExperiment& experiment) {
  const Course course = load_course(experiment.course);
  const ExperimentOutput output(experiment.folder, "failsafe");
  ResultTable table{{"", "speed before [m/s]", "to zero command, worst [s]", "to standstill, worst [s]",
                     "rolled, worst [m]", "stop reason"},
                    {}};
  PngChart chart("Speed after a fault, first drive", {0.0, kDrawn_s, "time since the fault [s]"},
                 {0.0, 1.4, "speed [m/s]"});
  nlohmann::ordered_json json;
  for (const SimFault fault : kSimFaults) {
    std::vector<Outcome> outcomes;
    for (int d = 0; d < experiment.drives; ++d) {
      const std::uint64_t seed = experiment.seed + static_cast<unsigned>(d);
      outcomes.push_back(drive(experiment, build_world(course, seed), seed, fault));
      json[name_of(fault)].push_back(json_of(outcomes.back()));
      fmt::print(stderr, "\r{}, drive {} of {}          ", name_of(fault), d + 1, experiment.drives);
    }
    table.rows.push_back(row(fault, outcomes));
    auto& speeds = outcomes.front().speeds;
    std::erase_if(speeds, [](const cv::Point2d& p) { return p.x > kDrawn_s; });
    chart.line(speeds, color_of_line(static_cast<std::size_t>(fault)), name_of(fault));
  }
  cv::imwrite(output.path(".png"), chart.picture());
  output.write(json, table.markdown());
  fmt::print(stderr, "\n");
  fmt::print("{}", table.markdown());
  return kExitOk;
}

}  // namespace hindsight::tools
