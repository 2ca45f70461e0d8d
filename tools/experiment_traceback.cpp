// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/experiment_traceback.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <span>
#include <string>
#include <vector>

#include "config/exit_code.h"
#include "sim_replay/world/course.h"
#include "tools/builtin_config.h"
#include "tools/experiment_output.h"
#include "tools/png_chart.h"
#include "tools/statistics.h"
#include "tools/traceback_truth.h"
#include "tools/training_drive.h"

namespace hindsight::tools {
namespace {

/// In units of `every`: 10 to 150 frames by default.
constexpr std::array kSteps{1, 3, 5, 10, 15};
constexpr int kGrid_px = 24;
constexpr std::array kFrom_m{2.0, 5.0, 10.0, 20.0};
/// Of a clear sky's sun: what clouds take, at their densest.
constexpr double kCloudDepth = 0.9;

/// Of one arm and number of frames.
struct Errors {
  std::array<std::vector<double>, kFrom_m.size()> px;  ///< by the distance then
  std::vector<double> returned_px;                     ///< of things that had left the view in between
  int lost = 0;  ///< was in view all the time, but the traceback ended before
  int returned_lost = 0;

  std::vector<double> all_px() const {
    std::vector<double> all;
    for (const auto& bin : px) all.insert(all.end(), bin.begin(), bin.end());
    return all;
  }
  void add(const TracebackTruth::Place& truth, const FlowHistory::Trace& trace, int frames) {
    const double error_px = std::hypot(static_cast<double>(trace.point_px.x_px) - truth.px.x_px,
                                       static_cast<double>(trace.point_px.y_px) - truth.px.y_px);
    const bool arrived = trace.frames_back == frames;
    if (truth.left_view) {
      arrived ? returned_px.push_back(error_px) : void(++returned_lost);
      return;
    }
    const auto bin = std::upper_bound(kFrom_m.begin(), kFrom_m.end(), truth.distance_m) - kFrom_m.begin() - 1;
    if (bin < 0) return;
    arrived ? px[static_cast<std::size_t>(bin)].push_back(error_px) : void(++lost);
  }
};
using ArmErrors = std::array<Errors, kSteps.size()>;

void trace_all(const TrainingDrive& drive, const TracebackTruth& truth, int every,
               std::vector<ArmErrors>& errors) {
  for (int row = kGrid_px / 2; row < drive.camera().height_px; row += kGrid_px) {
    for (int column = kGrid_px / 2; column < drive.camera().width_px; column += kGrid_px) {
      for (std::size_t s = 0; s < kSteps.size(); ++s) {
        const int frames = kSteps[s] * every;
        const auto place = truth.place_of(column, row, frames);
        if (!place) continue;
        for (std::size_t a = 0; a < errors.size(); ++a) {
          const FlowHistory& history = drive.robot(a).sight().history();
          if (history.size() < frames) continue;
          errors[a][s].add(*place,
                           history.trace_back({static_cast<float>(column), static_cast<float>(row)}, frames),
                           frames);
        }
      }
    }
  }
}

struct Sky {
  std::string name;
  Course course;
};

/// The course's own light, and a clear sky without and with clouds that pass.
std::vector<Sky> skies_over(const Course& course) {
  Course clear = course;
  clear.light.sun_strength = 1.0;
  clear.light.cloud_depth = 0.0;
  Course clouds = clear;
  clouds.light.cloud_depth = kCloudDepth;
  return {{"the course's light", course}, {"sun", clear}, {"sun and clouds", clouds}};
}

double mean_grey(std::span<const std::uint8_t> bgr) {
  double sum = 0.0;
  for (const std::uint8_t value : bgr) sum += value;
  return bgr.empty() ? 0.0 : sum / static_cast<double>(bgr.size());
}

std::vector<double> changes_over_a_second(std::span<const double> grey) {
  constexpr std::size_t kSecond = 10;  // frames
  std::vector<double> changes;
  for (std::size_t i = kSecond; i < grey.size(); ++i)
    changes.push_back(std::abs(grey[i] / grey[i - kSecond] - 1.0));
  return changes;
}

struct DriveErrors {
  std::vector<ArmErrors> arms;
  std::vector<double> grey;  ///< of each picture, its mean
};

DriveErrors drive(const TracebackExperiment& experiment, const World& world, const std::vector<Arm>& arms) {
  TrainingDrive drive(world, experiment.seed, 0, arms);
  TracebackTruth truth(drive.camera(), kSteps.back() * experiment.every, experiment.every);
  DriveErrors errors{std::vector<ArmErrors>(arms.size()), {}};
  for (int frame = 0; frame < experiment.frames; ++frame) {
    drive.step();
    errors.grey.push_back(mean_grey(drive.input().frame->bgr));
    truth.push(drive.feed().X_WB(), drive.feed().rendered().depth_m);
    if (frame % experiment.every == 0) trace_all(drive, truth, experiment.every, errors.arms);
    if (frame % 10 == 0) fmt::print(stderr, "\rframe {} of {}   ", frame, experiment.frames);
  }
  return errors;
}

std::string cell(const std::vector<double>& px) {
  if (px.empty()) return "-";
  return fmt::format("{:.1f} / {:.1f}", quantile_of(px, 0.5), quantile_of(px, 0.75));
}

nlohmann::ordered_json json_of(const std::vector<double>& px) {
  return {{"points", px.size()}, {"median_px", quantile_of(px, 0.5)}, {"p75_px", quantile_of(px, 0.75)}};
}

nlohmann::ordered_json json_of(const Errors& errors) {
  nlohmann::ordered_json json = json_of(errors.all_px());
  json["ended_early"] = errors.lost;
  for (std::size_t b = 0; b < kFrom_m.size(); ++b)
    json["by_distance"][fmt::format("from_{:g}_m", kFrom_m[b])] = json_of(errors.px[b]);
  json["left_view_and_returned"] = json_of(errors.returned_px);
  json["left_view_and_returned"]["ended_early"] = errors.returned_lost;
  return json;
}

std::vector<std::string> row(const std::string& name, int frames, const Errors& errors) {
  std::vector<std::string> cells{name, std::to_string(frames), cell(errors.all_px())};
  for (const auto& bin : errors.px) cells.push_back(cell(bin));
  const std::size_t points = errors.all_px().size();
  cells.push_back(fmt::format(
      "{:.1f} %",
      points > 0 ? 100.0 * errors.lost / static_cast<double>(points + static_cast<std::size_t>(errors.lost))
                 : 0.0));
  cells.push_back(errors.returned_px.empty() ? std::string("-") : cell(errors.returned_px));
  cells.push_back(fmt::format("{} of {}", errors.returned_px.size(),
                              errors.returned_px.size() + static_cast<std::size_t>(errors.returned_lost)));
  return cells;
}

}  // namespace

int run_traceback_experiment(const TracebackExperiment& experiment) {
  const std::vector<Sky> skies = skies_over(load_course(experiment.course));
  const ExperimentOutput output(experiment.folder, "traceback");
  const std::vector<Arm> arms{{"thesis", thesis_configuration()}, {"default", Configuration{}}};
  ResultTable table{{"", "frames back", "error, median / 75 % [px]", "2 to 5 m", "5 to 10 m", "10 to 20 m",
                     "over 20 m", "ended early", "left view and returned", "of these traced"},
                    {}};
  nlohmann::ordered_json json;
  PngChart chart("Median error of tracebacks", {0.0, 1.05 * kSteps.back() * experiment.every, "frames back"},
                 {0.3, 300.0, "error [px]", true});
  std::size_t lines = 0;
  std::string brightness;
  for (const Sky& sky : skies) {
    const DriveErrors errors = drive(experiment, build_world(sky.course, experiment.seed), arms);
    const std::vector<double> change = changes_over_a_second(errors.grey);
    json["brightness_change_over_a_second"][sky.name] = {{"median", quantile_of(change, 0.5)},
                                                         {"p95", quantile_of(change, 0.95)}};
    brightness += fmt::format("Mean grey changes over a second, {}: {:.0f} % (median), {:.0f} % (95 %).\n",
                              sky.name, 100.0 * quantile_of(change, 0.5), 100.0 * quantile_of(change, 0.95));
    for (std::size_t a = 0; a < arms.size(); ++a) {
      const std::string name = fmt::format("{}, {}", arms[a].name, sky.name);
      std::vector<cv::Point2d> points;
      for (std::size_t s = 0; s < kSteps.size(); ++s) {
        const int frames = kSteps[s] * experiment.every;
        table.rows.push_back(row(name, frames, errors.arms[a][s]));
        json[name][std::to_string(frames)] = json_of(errors.arms[a][s]);
        const std::vector<double> px = errors.arms[a][s].all_px();
        if (!px.empty()) points.emplace_back(frames, quantile_of(px, 0.5));
      }
      chart.line(points, color_of_line(lines++), name);
    }
  }
  cv::imwrite(output.path(".png"), chart.picture());
  output.write(json, table.markdown() + "\n" + brightness);
  fmt::print(stderr, "\n");
  fmt::print("{}", table.markdown());
  return kExitOk;
}

}  // namespace hindsight::tools
