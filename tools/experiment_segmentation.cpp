// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/experiment_segmentation.h"

#include <fmt/format.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "config/exit_code.h"
#include "sim_replay/world/course.h"
#include "tools/experiment_output.h"
#include "tools/report_frame.h"
#include "tools/report_style.h"
#include "tools/segmentation_score.h"
#include "tools/training_drive.h"

namespace hindsight::tools {
namespace {

constexpr double kRange_m = 25.0;
constexpr int kMostTrainingTicks = 6000;

struct Total {
  double coverage_sum = 0.0, ground_m2 = 0.0, wrong_m2 = 0.0;
  int obstacles = 0, frames = 0;

  void add(const SegmentationScore& score) {
    coverage_sum += score.coverage_sum;
    obstacles += score.obstacles;
    ground_m2 += score.ground_m2;
    wrong_m2 += score.wrong_m2;
    ++frames;
  }
  double coverage() const { return obstacles > 0 ? coverage_sum / obstacles : 0.0; }
  double wrong() const { return ground_m2 > 0.0 ? wrong_m2 / ground_m2 : 0.0; }
};

/// All arms, and the position prior behind them.
struct Standing {
  std::vector<Arm> arms;
  std::vector<Total> totals;
};

void tint(cv::Mat& picture, auto&& color_of_pixel) {
  for (int i = 0; i < picture.rows * picture.cols; ++i) {
    if (const std::optional<cv::Vec3b> color = color_of_pixel(static_cast<std::size_t>(i))) {
      auto& pixel = picture.at<cv::Vec3b>(i / picture.cols, i % picture.cols);
      for (int k = 0; k < 3; ++k) pixel[k] = static_cast<std::uint8_t>((pixel[k] + 2 * (*color)[k]) / 3);
    }
  }
}

void title(cv::Mat& picture, const std::string& text) {
  cv::putText(picture, text, {10, 26}, cv::FONT_HERSHEY_SIMPLEX, 0.7, kInk.bgr(), 4, cv::LINE_AA);
  cv::putText(picture, text, {10, 26}, cv::FONT_HERSHEY_SIMPLEX, 0.7, kPaper.bgr(), 1, cv::LINE_AA);
}

/// Figure 5.11: the frame, the obstacles in it, and what each arm makes of it.
cv::Mat draw_figure(const TrainingDrive& drive, const SegmentationTruth& truth,
                    const std::vector<Arm>& arms) {
  const Frame& frame = *drive.input().frame;
  const cv::Mat view = view_of(frame.bgr, frame.width_px, frame.height_px);
  std::vector<cv::Mat> panels{view.clone(), view.clone()};
  tint(panels[1], [&](std::size_t i) -> std::optional<cv::Vec3b> {
    return truth.obstacle[i] != 0 ? std::optional(kLethal.pixel()) : std::nullopt;
  });
  title(panels[0], "(a) frame");
  title(panels[1], "(b) obstacles");
  for (std::size_t a = 0; a < arms.size(); ++a) {
    const auto labels = drive.robot(a).sight().labels();
    panels.push_back(view.clone());
    tint(panels.back(), [&](std::size_t i) -> std::optional<cv::Vec3b> {
      return labels[i] == TerrainClass::unknown ? std::nullopt : std::optional(color_of(labels[i]).pixel());
    });
    title(panels.back(), fmt::format("({}) {}", static_cast<char>('c' + a), arms[a].name));
  }
  cv::Mat rows, row;
  for (std::size_t i = 0; i + 1 < panels.size(); i += 2) {
    cv::hconcat(panels[i], panels[i + 1], row);
    rows.empty() ? rows = row.clone() : (cv::vconcat(rows, row, rows), rows);
  }
  return rows;
}

void train(TrainingDrive& drive, int number) {
  for (int tick = 0; !drive.trained(); ++tick) {
    if (tick == kMostTrainingTicks)
      throw FatalError(kExitBadData, "the course has too few trees in reach to drive into");
    drive.step();
    if (tick % 50 == 0)
      fmt::print(stderr, "\rdrive {}: {} touches, {} ticks   ", number, drive.touches(), tick);
  }
}

/// Obstacle where more than half of the other drives' frames have one at that pixel.
std::vector<TerrainClass> prior_without(std::span<const std::vector<SegmentationTruth>> drives,
                                        std::size_t own) {
  std::vector<int> seen;
  int frames = 0;
  for (std::size_t d = 0; d < drives.size(); ++d) {
    if (d == own) continue;
    for (const SegmentationTruth& truth : drives[d]) {
      seen.resize(truth.obstacle.size());
      for (std::size_t i = 0; i < seen.size(); ++i) seen[i] += truth.obstacle[i] != 0;
      ++frames;
    }
  }
  std::vector<TerrainClass> prior(seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i)
    prior[i] = 2 * seen[i] > frames ? TerrainClass::lethal : TerrainClass::good;
  return prior;
}

void save_mixtures(const TrainingDrive& drive, const std::vector<Arm>& arms, const ExperimentOutput& output) {
  for (std::size_t a = 0; a < arms.size(); ++a) {
    const std::vector<std::uint8_t> bytes = drive.mixture(a);
    std::ofstream file(output.path("_" + arms[a].name + ".mixture"), std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
}

ResultTable table_of(const Standing& standing) {
  ResultTable table{{"", "obstacle coverage", "ground wrongly called obstacle", "frames"}, {}};
  const auto add = [&](const std::string& name, const Total& total) {
    table.rows.push_back({name, fmt::format("{:.1f} %", 100 * total.coverage()),
                          fmt::format("{:.1f} %", 100 * total.wrong()), std::to_string(total.frames)});
  };
  for (std::size_t a = 0; a < standing.arms.size(); ++a) add(standing.arms[a].name, standing.totals[a]);
  add("position prior", standing.totals.back());
  return table;
}

nlohmann::ordered_json json_of(const Standing& standing) {
  nlohmann::ordered_json result;
  for (std::size_t a = 0; a < standing.totals.size(); ++a) {
    const Total& t = standing.totals[a];
    const std::string name = a < standing.arms.size() ? standing.arms[a].name : "position_prior";
    result[name] = {{"coverage", t.coverage()},
                    {"wrong_area", t.wrong()},
                    {"frames", t.frames},
                    {"obstacles", t.obstacles}};
  }
  return result;
}

}  // namespace

int run_segmentation_experiment(const SegmentationExperiment& experiment) {
  const Course course = load_course(experiment.course);
  const ExperimentOutput output(experiment.folder, "segmentation");
  Standing standing{segmentation_arms(), std::vector<Total>(segmentation_arms().size() + 1)};
  std::vector<std::vector<SegmentationTruth>> truths(static_cast<std::size_t>(experiment.drives));
  std::optional<SegmentationJudge> judge;
  const int frames_each = (experiment.frames + experiment.drives - 1) / experiment.drives;
  for (int d = 0; d < experiment.drives; ++d) {
    const std::uint64_t seed = experiment.seed + static_cast<unsigned>(d);
    TrainingDrive drive(build_world(course, seed), seed, experiment.bumps, standing.arms);
    if (!judge) judge.emplace(drive.camera(), kRange_m);
    train(drive, d + 1);
    std::size_t most_obstacles = 0;
    for (int f = 0; f < frames_each; ++f) {
      for (int i = 0; i < experiment.every; ++i) drive.step();
      const SegmentationTruth truth =
          judge->truth_of(drive.feed().rendered(), drive.feed().X_WB(), drive.feed().world());
      for (std::size_t a = 0; a < standing.arms.size(); ++a) {
        standing.totals[a].add(judge->judge(truth, drive.robot(a).sight().labels()));
      }
      const auto obstacles =
          static_cast<std::size_t>(judge->judge(truth, drive.robot(0).sight().labels()).obstacles);
      if (d == 0 && obstacles > most_obstacles) {
        most_obstacles = obstacles;
        cv::imwrite(output.path(".png"), draw_figure(drive, truth, standing.arms));
      }
      truths[static_cast<std::size_t>(d)].push_back(truth);
      fmt::print(stderr, "\rdrive {}: {} of {} labelled frames   ", d + 1, f + 1, frames_each);
    }
    save_mixtures(drive, standing.arms, output);
  }
  for (std::size_t d = 0; d < truths.size(); ++d) {
    const std::vector<TerrainClass> prior = prior_without(truths, d);
    for (const SegmentationTruth& truth : truths[d]) standing.totals.back().add(judge->judge(truth, prior));
  }
  const std::string table = table_of(standing).markdown();
  output.write(json_of(standing), table);
  fmt::print(stderr, "\n");
  fmt::print("{}", table);
  return kExitOk;
}

}  // namespace hindsight::tools
