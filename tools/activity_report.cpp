// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/activity_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "tools/png_chart.h"
#include "tools/statistics.h"

namespace hindsight::tools {
namespace {

std::vector<double> values(const std::vector<nlohmann::ordered_json>& all, std::size_t map, const char* key) {
  std::vector<double> list;
  for (const nlohmann::ordered_json& json : all) list.push_back(json["tracking"][map][key].get<double>());
  return list;
}

double total(const std::vector<double>& list) {
  double sum = 0.0;
  for (const double v : list) sum += v;
  return sum;
}

/// Over all worlds' frames together.
double pooled_accuracy(const std::vector<nlohmann::ordered_json>& all, std::size_t map) {
  const double tp = total(values(all, map, "tp")), fp = total(values(all, map, "fp")),
               fn = total(values(all, map, "fn"));
  return tp + fn > 0.0 ? (tp - fp) / (tp + fn) : 0.0;
}

/// Steps of 0.02, and one at least, about what there is.
cv::Mat draw_accuracy(const std::vector<cv::Point2d>& line) {
  constexpr double kStep = 0.02;
  const auto [least, most] = std::ranges::minmax(line, {}, &cv::Point2d::y);
  const double from = kStep * std::floor(least.y / kStep);
  PngChart chart("Accuracy of tracking over objects in the training data", {0.0, 84.0, "objects"},
                 {from, std::max(from + kStep, kStep * std::ceil(most.y / kStep)), "accuracy"});
  chart.line(line, color_of_line(0), "accuracy");
  return chart.picture();
}

}  // namespace

void report_activity(const ActivityExperiment& experiment, const ExperimentOutput& output,
                     const std::vector<nlohmann::ordered_json>& all) {
  ResultTable table{{"map learned from", "accuracy", "MOTA", "IDF1", "TP", "TN", "FP", "FN",
                     "identity switches", "p against none"},
                    {}};
  std::vector<cv::Point2d> line;
  nlohmann::ordered_json json;
  json["worlds"] = all.size(), json["frames"] = experiment.frames;
  const std::vector<double> without = values(all, 0, "accuracy");
  for (std::size_t k = 0; k < kObjects.size(); ++k) {
    std::vector<double> gain = values(all, k, "accuracy");
    for (std::size_t i = 0; i < gain.size(); ++i) gain[i] -= without[i];
    const double p = k == 0 ? 1.0 : sign_flip_p_value(gain, experiment.seed);
    const double accuracy = pooled_accuracy(all, k);
    const auto sum = [&](const char* key) { return fmt::format("{:.0f}", total(values(all, k, key))); };
    table.rows.push_back({k == 0 ? "nothing" : fmt::format("{} objects", kObjects[k]),
                          fmt::format("{:.3f}", accuracy),
                          fmt::format("{:.3f}", mean_of(values(all, k, "mota"))),
                          fmt::format("{:.3f}", mean_of(values(all, k, "idf1"))), sum("tp"), sum("tn"),
                          sum("fp"), sum("fn"), sum("id_switches"), k == 0 ? "-" : fmt::format("{:.5f}", p)});
    json["tracking"].push_back(
        {{"objects", kObjects[k]}, {"accuracy", accuracy}, {"mean_gain", mean_of(gain)}, {"p", p}});
    line.emplace_back(kObjects[k], accuracy);
  }
  cv::imwrite(output.path("_objects.png"), draw_accuracy(line));
  std::vector<double> cells, degrees;
  int close = 0, right = 0, sp = 0, sn = 0;
  for (const nlohmann::ordered_json& one : all) {
    cells.push_back(one["registration"]["cells"].get<double>()),
        degrees.push_back(one["registration"]["degrees"].get<double>());
    close += cells.back() <= 2.0 && degrees.back() <= 3.0;
    right += one["roundabout"] == one["taken_for_roundabout"];
    sp += one["single"]["fp"].get<int>(), sn += one["single"]["fn"].get<int>();
  }
  const auto n = static_cast<double>(all.size());
  json["registration"] = {{"within_2_cells_and_3_degrees", close / n},
                          {"median_cells", quantile_of(cells, 0.5)},
                          {"median_degrees", quantile_of(degrees, 0.5)},
                          {"template_right", right / n}};
  json["single_object"] = {{"mean_fp", sp / n}, {"mean_fn", sn / n}};

  const std::string more = fmt::format(
      "\nOne person alone, {} frames, mean over the worlds: {:.1f} FP, {:.1f} FN.\n\nRegistration by motion "
      "alone: {:.0f} % within 2 cells "
      "and 3 degrees; median {:.2f} cells and {:.2f} degrees. Crossroads or roundabout told rightly by "
      "template: {:.0f} %.\n",
      kSingleFrames, sp / n, sn / n, 100.0 * close / n, quantile_of(cells, 0.5), quantile_of(degrees, 0.5),
      100.0 * right / n);
  output.write(json, table.markdown() + more);
  fmt::print("{}{}", table.markdown(), more);
}

}  // namespace hindsight::tools
