// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/experiment_navigation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <opencv2/imgcodecs.hpp>

#include "config/exit_code.h"
#include "sim_replay/read_file.h"
#include "sim_replay/world/course.h"
#include "sim_replay/world/random.h"
#include "tools/experiment_output.h"
#include "tools/navigation_figures.h"
#include "tools/process_pool.h"
#include "tools/sim_run.h"
#include "tools/statistics.h"
#include "tools/training_drive.h"

namespace hindsight::tools {
namespace {

constexpr double kStartRadius_m = 5.0;
constexpr int kMostDrawings = 100;
constexpr int kTicksPerPathPoint = 5;

/// Without and with reverse flow.
std::vector<Arm> arms_of(const std::string& numbers) {
  const std::string without = numbers == "thesis" ? "no_reverse_flow" : numbers + "_no_reverse_flow";
  std::vector<Arm> arms = segmentation_arms();
  std::erase_if(arms, [&](const Arm& arm) { return arm.name != without && arm.name != numbers; });
  return arms;
}

std::vector<std::string> names_of(const std::vector<Arm>& arms) {
  std::vector<std::string> names;
  for (const Arm& arm : arms) names.push_back(arm.name);
  return names;
}

struct Case {
  Arm arm;
  unsigned world_seed;
  int start;
};

/// The course with its start moved within kStartRadius_m, the same for all arms; somewhere else where a tree
/// is.
World world_with_start(Course course, unsigned seed, int start) {
  Random random(seed, static_cast<std::uint64_t>(start) + 1000);
  const StartParams middle = course.start;
  for (int drawing = 0; drawing < kMostDrawings; ++drawing) {
    const double x = random.uniform(-kStartRadius_m, kStartRadius_m),
                 y = random.uniform(-kStartRadius_m, kStartRadius_m);
    if (x * x + y * y > kStartRadius_m * kStartRadius_m) continue;
    course.start.x_m = middle.x_m + x;
    course.start.aside_m = middle.aside_m + y;
    try {
      return build_world(course, seed);
    } catch (const FatalError&) {
      // Inside a tree, or without a way to the goal: draw again.
    }
  }
  throw FatalError(kExitConfiguration, course.file + ": no free start within 5 m");
}

nlohmann::json to_json(const NavigationRun& run) {
  nlohmann::json path = nlohmann::json::array();
  for (const WorldPoint& p : run.path)
    path.push_back({std::round(p.x_m * 100) / 100, std::round(p.y_m * 100) / 100});
  return {{"arm", run.arm},         {"world_seed", run.world_seed},
          {"start", run.start},     {"seconds", run.seconds},
          {"touches", run.touches}, {"ir_touches", run.ir_touches},
          {"reached", run.reached}, {"path", path}};
}

NavigationRun from_json(const nlohmann::json& json) {
  NavigationRun run{json.at("arm"),     json.at("world_seed"), json.at("start"),   json.at("seconds"),
                    json.at("touches"), json.at("ir_touches"), json.at("reached"), {}};
  for (const auto& p : json.at("path")) run.path.push_back({p.at(0), p.at(1)});
  return run;
}

NavigationRun drive(const NavigationExperiment& experiment, const Course& course, const Case& which,
                    const std::vector<std::uint8_t>& mixture) {
  Configuration configuration = which.arm.configuration;
  configuration.robot.learning = false;
  SimRun sim({.configuration = configuration,
              .world = world_with_start(course, which.world_seed, which.start),
              .seed = which.world_seed * 1000 + static_cast<unsigned>(which.start),
              .mixture = mixture});
  NavigationRun run{which.arm.name, which.world_seed, which.start, 0.0, 0, 0, false, {}};
  SimSummary now;
  while (!now.reached && now.seconds < experiment.seconds) {
    sim.step();
    now = sim.summary();
    if (now.ticks % kTicksPerPathPoint == 1)
      run.path.push_back({sim.feed().X_WB().x_m, sim.feed().X_WB().y_m});
  }
  run.seconds = now.seconds;
  run.touches = now.touches;
  run.ir_touches = now.ir_touches;
  run.reached = now.reached;
  return run;
}

std::vector<NavigationRun> read_runs(const std::string& path) {
  std::vector<NavigationRun> runs;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (!line.empty()) runs.push_back(from_json(nlohmann::json::parse(line)));
  }
  return runs;
}

std::vector<Case> missing_cases(const NavigationExperiment& experiment, const std::vector<Arm>& arms,
                                const std::vector<NavigationRun>& runs) {
  std::vector<Case> cases;
  for (int start = 0; start < experiment.starts; ++start) {
    for (int w = 0; w < experiment.worlds; ++w) {
      const unsigned seed = experiment.first_seed + static_cast<unsigned>(w);
      for (const Arm& arm : arms) {
        const bool there = std::any_of(runs.begin(), runs.end(), [&](const NavigationRun& run) {
          return run.arm == arm.name && run.world_seed == seed && run.start == start;
        });
        if (!there) cases.push_back({arm, seed, start});
      }
    }
  }
  return cases;
}

/// Arm 0 minus arm 1, over the starts that both have driven.
std::vector<double> differences(const std::vector<std::string>& arms, const std::vector<NavigationRun>& runs,
                                auto&& value) {
  std::vector<double> all;
  for (const NavigationRun& a : runs) {
    for (const NavigationRun& b : runs) {
      if (a.arm == arms[0] && b.arm == arms[1] && a.world_seed == b.world_seed && a.start == b.start)
        all.push_back(value(a) - value(b));
    }
  }
  return all;
}

void conclude(const NavigationExperiment& experiment, const Course& course,
              const std::vector<std::string>& arms, const std::vector<NavigationRun>& runs,
              const ExperimentOutput& output) {
  const auto seconds_of = [](const NavigationRun& run) { return run.seconds; };
  const auto touches_of = [](const NavigationRun& run) { return static_cast<double>(run.all_touches()); };
  nlohmann::ordered_json result;
  ResultTable table{
      {"", "runs", "goal reached", "mean time [s]", "mean touches (bumper + IR)", "of these bumper"}, {}};
  for (const std::string& arm : arms) {
    std::vector<double> seconds, touches, bumper;
    int reached = 0;
    for (const NavigationRun& run : runs) {
      if (run.arm != arm) continue;
      seconds.push_back(seconds_of(run)), touches.push_back(touches_of(run)), bumper.push_back(run.touches);
      reached += run.reached;
    }
    result[arm] = {{"runs", seconds.size()},
                   {"reached", reached},
                   {"seconds", mean_of(seconds)},
                   {"touches", mean_of(touches)},
                   {"bumper_touches", mean_of(bumper)}};
    table.rows.push_back({arm, std::to_string(seconds.size()), std::to_string(reached),
                          fmt::format("{:.1f}", mean_of(seconds)), fmt::format("{:.2f}", mean_of(touches)),
                          fmt::format("{:.2f}", mean_of(bumper))});
  }
  const std::vector<double> time = differences(arms, runs, seconds_of),
                            touch = differences(arms, runs, touches_of);
  result["paired"] = {{"pairs", time.size()},
                      {"p_seconds", sign_flip_p_value(time, 1)},
                      {"p_touches", sign_flip_p_value(touch, 2)}};
  output.write(
      result, table.markdown() +
                  fmt::format("\nPaired sign-flip test over {} pairs: time p = {:.2g}, touches p = {:.2g}.\n",
                              time.size(), sign_flip_p_value(time, 1), sign_flip_p_value(touch, 2)));
  std::vector<World> worlds;
  for (int w = 0; w < experiment.worlds; ++w)
    worlds.push_back(build_world(course, experiment.first_seed + static_cast<unsigned>(w)));
  cv::imwrite(output.path("_paths.png"), draw_paths(worlds, arms, runs));
  cv::imwrite(output.path("_ellipses.png"), draw_ellipses(arms, runs));
  fmt::print("{}", table.markdown());
}

}  // namespace

int run_navigation_experiment(const NavigationExperiment& experiment) {
  const Course course = load_course(experiment.course);
  const std::string name =
      experiment.numbers == "default" ? "navigation" : "navigation_" + experiment.numbers;
  const ExperimentOutput output(experiment.folder, name);
  const std::vector<Arm> arms = arms_of(experiment.numbers);
  const std::string log = output.path("_runs.jsonl");
  std::vector<NavigationRun> runs = read_runs(log);
  const std::vector<Case> cases = missing_cases(experiment, arms, runs);
  std::map<std::string, std::vector<std::uint8_t>> mixtures;
  for (const Arm& arm : arms) {
    mixtures[arm.name] =
        read_file<std::vector<std::uint8_t>>(experiment.folder + "/segmentation_" + arm.name + ".mixture");
  }
  const std::size_t all = runs.size() + cases.size();
  std::ofstream file(log, std::ios::app);
  const auto work = [&](int i) {
    const Case& which = cases[static_cast<std::size_t>(i)];
    return to_json(drive(experiment, course, which, mixtures.at(which.arm.name))).dump();
  };
  const auto done = [&](int, const std::string& text) {
    file << text << std::endl;
    runs.push_back(from_json(nlohmann::json::parse(text)));
    const NavigationRun& run = runs.back();
    fmt::print(stderr, "{} of {}: {} world {} start {}: {:.0f} s, {} + {} touches{}\n", runs.size(), all,
               run.arm, run.world_seed, run.start, run.seconds, run.touches, run.ir_touches,
               run.reached ? "" : ", goal not reached");
  };
  const int failed = run_in_processes(static_cast<int>(cases.size()), experiment.processes, work, done);
  conclude(experiment, course, names_of(arms), runs, output);
  return failed == 0 ? kExitOk : kExitSoftware;
}

}  // namespace hindsight::tools
