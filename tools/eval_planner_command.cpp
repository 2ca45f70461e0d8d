// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/eval_planner_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "config/exit_code.h"
#include "planning/dstar.h"
#include "tools/cpu_time.h"
#include "tools/movingai.h"
#include "tools/number_checks.h"

namespace hindsight::tools {

namespace {

constexpr int kEdits = 10;
constexpr int kReach = 10;
constexpr double kTolerance = 1e-4;

std::vector<std::filesystem::path> maps_in(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder))
    throw FatalError(kExitNoInput,
                     fmt::format("{}: expected a folder of .map and .map.scen files", folder.string()));
  std::vector<std::filesystem::path> maps;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".map") maps.push_back(entry.path());
  if (maps.empty())
    throw FatalError(kExitNoInput, fmt::format("{}: expected at least one .map file", folder.string()));
  std::sort(maps.begin(), maps.end());
  return maps;
}

struct Scenario {
  MovingAiMap map;
  std::vector<MovingAiProblem> problems;
};

double length_of(std::span<const int> path, int width) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const int step = std::abs(path[i] - path[i - 1]);
    length += step == 1 || step == width ? 1.0 : std::sqrt(2.0);
  }
  return length;
}

// Solves the problems of one map.
class MapEvaluation {
 public:
  explicit MapEvaluation(const MovingAiMap& map)
      : map_(map), dstar_(map.width, map.height), path_(map.costs.size()), random_(1) {
    dstar_.init(map.costs);
  }

  bool solve(const MovingAiProblem& problem, std::vector<double>& times_us) {
    dstar_.set_goal(problem.goal);
    PathCost cost = 0;
    times_us.push_back(microseconds([&] { cost = dstar_.replan(problem.start); }));
    const auto count = static_cast<std::size_t>(dstar_.extract_path(path_));
    if (problem.unreachable || cost == kUnreachable) return problem.unreachable && cost == kUnreachable;
    const double length = length_of({path_.data(), count}, map_.width);
    return std::abs(length - problem.optimal_length) <= kTolerance * std::max(1.0, problem.optimal_length);
  }

  void repair(const MovingAiProblem& problem, std::vector<double>& times_us) {
    choose_edits(problem);
    for (const int cell : edits_) dstar_.set_cost(cell, kLethalCost);
    times_us.push_back(microseconds([&] { dstar_.replan(problem.start); }));
    for (const int cell : edits_) dstar_.set_cost(cell, kFreeCost);
  }

 private:
  void choose_edits(const MovingAiProblem& problem) {
    edits_.clear();
    const int x = problem.start % map_.width, y = problem.start / map_.width;
    for (int k = 0; k < kEdits; ++k) {
      const int i = x + offset(), j = y + offset();
      if (i < 0 || j < 0 || i >= map_.width || j >= map_.height) continue;
      const int cell = j * map_.width + i;
      if (cell == problem.start || cell == problem.goal || dstar_.cost(cell) == kLethalCost) continue;
      edits_.push_back(cell);
    }
  }
  int offset() { return static_cast<int>(random_() % (2 * kReach + 1)) - kReach; }

  const MovingAiMap& map_;
  DStar dstar_;
  std::vector<int> path_;
  std::vector<int> edits_;
  std::mt19937 random_;
};

std::string to_json(const PlannerEvaluation& e) {
  const nlohmann::ordered_json json = {{"maps", e.maps},
                                       {"problems", e.problems},
                                       {"optimal", e.optimal},
                                       {"median_us", e.median_us},
                                       {"p95_us", e.p95_us},
                                       {"max_us", e.max_us},
                                       {"replan_median_us", e.replan_median_us},
                                       {"replan_p95_us", e.replan_p95_us},
                                       {"seconds", e.seconds}};
  return json.dump();
}

std::string to_text(const PlannerEvaluation& e) {
  return fmt::format(
      "{} problems on {} maps, {} solved optimally\n"
      "search from nothing: median {:.0f} us, 95 % below {:.0f} us, longest {:.0f} us\n"
      "repair after {} cells near the start were shut: median {:.1f} us, 95 % below {:.0f} us\n"
      "{:.1f} s in all",
      e.problems, e.maps, e.optimal, e.median_us, e.p95_us, e.max_us, kEdits, e.replan_median_us,
      e.replan_p95_us, e.seconds);
}

}  // namespace

PlannerEvaluation evaluate_planner(const std::filesystem::path& folder, int limit) {
  const double begin_us = thread_cpu_us();
  std::vector<Scenario> scenarios;
  std::int64_t total = 0;
  for (const std::filesystem::path& path : maps_in(folder)) {
    Scenario scenario{read_movingai_map(path), {}};
    scenario.problems = read_movingai_scenario(path.string() + ".scen", scenario.map);
    total += static_cast<std::int64_t>(scenario.problems.size());
    scenarios.push_back(std::move(scenario));
  }
  const std::int64_t wanted = limit > 0 ? std::min<std::int64_t>(limit, total) : total;
  PlannerEvaluation result;
  std::vector<double> search_us, repair_us;
  std::int64_t index = 0;
  for (const Scenario& scenario : scenarios) {
    MapEvaluation evaluation(scenario.map);
    ++result.maps;
    for (const MovingAiProblem& problem : scenario.problems) {
      ++index;
      if (index * wanted / total == (index - 1) * wanted / total) continue;
      ++result.problems;
      result.optimal += evaluation.solve(problem, search_us) ? 1 : 0;
      evaluation.repair(problem, repair_us);
    }
  }
  result.median_us = quantile(search_us, 0.5);
  result.p95_us = quantile(search_us, 0.95);
  result.max_us = quantile(search_us, 1.0);
  result.replan_median_us = quantile(repair_us, 0.5);
  result.replan_p95_us = quantile(repair_us, 0.95);
  result.seconds = (thread_cpu_us() - begin_us) * 1e-6;
  return result;
}

void add_eval_planner(CLI::App& eval, Run& run) {
  struct Options {
    std::string maps;
    int limit = 0;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* app =
      eval.add_subcommand("planner", "D* on Moving AI maps: are its paths optimal, how long does it take");
  app->add_option("--maps", options->maps, "folder of .map and .map.scen files")->required();
  app->add_option("--limit", options->limit, "at most so many problems, spread evenly (0: all)")
      ->check(zero_or_above());
  app->add_flag("--json", options->json, "print JSON");
  app->callback([&run, options] {
    run = [options] {
      const PlannerEvaluation result = evaluate_planner(options->maps, options->limit);
      fmt::print("{}\n", options->json ? to_json(result) : to_text(result));
      return static_cast<int>(result.optimal == result.problems ? kExitOk : kExitDiffers);
    };
  });
}

}  // namespace hindsight::tools
