// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/experiment_colours.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "config/exit_code.h"
#include "sim_replay/world/course.h"
#include "tools/experiment_output.h"
#include "tools/report_style.h"
#include "tools/training_drive.h"

namespace hindsight::tools {
namespace {

constexpr std::array kClassNames{"sky", "way", "ground beside it", "bushes and trees"};
constexpr std::size_t kClassCount = kClassNames.size();
constexpr std::array kChannelNames{"blue", "green", "red"};
constexpr std::array<Rgb, 3> kChannelColors{Rgb{47, 111, 178}, Rgb{46, 158, 91}, Rgb{214, 47, 58}};
constexpr int kTicksBetweenFrames = 10;

struct ColourStatistics {
  std::array<std::array<double, 256>, 3> counts{};  ///< by channel, blue first

  void add(const cv::Vec3b& pixel) {
    for (int k = 0; k < 3; ++k) ++counts[static_cast<std::size_t>(k)][pixel[k]];
  }
  double total() const {
    double sum = 0.0;
    for (const double count : counts[0]) sum += count;
    return sum;
  }
  double moment(std::size_t channel, double about, int power) const {
    double sum = 0.0;
    for (int value = 0; value < 256; ++value)
      sum += counts[channel][static_cast<std::size_t>(value)] * std::pow(value - about, power);
    return total() > 0.0 ? sum / total() : 0.0;
  }
  double mean(std::size_t channel) const { return moment(channel, 0.0, 1); }
  double deviation(std::size_t channel) const { return std::sqrt(moment(channel, mean(channel), 2)); }
};

using ByClass = std::array<ColourStatistics, kClassCount>;

/// YCOR's label colours, blue first.
std::optional<std::size_t> class_of_label(const cv::Vec3b& bgr) {
  struct Entry {
    cv::Vec3b bgr;
    std::size_t is;
  };
  static const std::array kEntries{Entry{{255, 88, 1}, 0},    Entry{{30, 76, 156}, 1},
                                   Entry{{153, 176, 178}, 1}, Entry{{0, 255, 128}, 2},
                                   Entry{{0, 80, 40}, 3},     Entry{{0, 160, 0}, 3}};
  for (const Entry& entry : kEntries) {
    if (entry.bgr == bgr) return entry.is;
  }
  return std::nullopt;
}

std::optional<std::size_t> class_of_truth(TruthLabel label) {
  switch (label) {
    case TruthLabel::sky:
      return 0;
    case TruthLabel::road:
      return 1;
    case TruthLabel::ground:
      return 2;
    case TruthLabel::tree:
    case TruthLabel::bush:
      return 3;
    case TruthLabel::fence:
    case TruthLabel::rock:
      return std::nullopt;
  }
  return std::nullopt;
}

cv::Mat read_picture(const std::filesystem::path& path) {
  cv::Mat picture = cv::imread(path.string(), cv::IMREAD_COLOR);
  if (picture.empty()) throw FatalError(kExitNoInput, path.string() + ": no picture that can be read");
  return picture;
}

ByClass look_at_stills(const std::string& folder) {
  if (!std::filesystem::is_directory(folder)) throw FatalError(kExitNoInput, folder + ": no such folder");
  ByClass seen;
  bool any = false;
  for (const auto& still : std::filesystem::directory_iterator(folder)) {
    if (!still.is_directory()) continue;
    any = true;
    const cv::Mat picture = read_picture(still.path() / "rgb.jpg");
    const cv::Mat labels = read_picture(still.path() / "labels.png");
    if (picture.size() != labels.size())
      throw FatalError(kExitBadData, still.path().string() + ": picture and labels differ in size");
    for (int row = 0; row < picture.rows; ++row) {
      for (int column = 0; column < picture.cols; ++column) {
        if (const auto is = class_of_label(labels.at<cv::Vec3b>(row, column)))
          seen[*is].add(picture.at<cv::Vec3b>(row, column));
      }
    }
  }
  if (!any)
    throw FatalError(kExitNoInput,
                     folder + ": holds no stills; expected folders with rgb.jpg and labels.png");
  return seen;
}

void look_at_course(const ColoursExperiment& experiment, const std::string& course, ByClass& seen) {
  const World world = build_world(load_course(course), experiment.seed);
  TrainingDrive drive(world, experiment.seed, 0, {{"camera only", Configuration{}}});
  for (int f = 0; f < experiment.frames; ++f) {
    for (int i = 0; i < kTicksBetweenFrames; ++i) drive.step();
    const RenderedFrame& frame = drive.feed().rendered();
    for (std::size_t i = 0; i < frame.labels.size(); ++i) {
      if (const auto is = class_of_truth(frame.labels[i]))
        seen[*is].add({frame.bgr[3 * i], frame.bgr[3 * i + 1], frame.bgr[3 * i + 2]});
    }
  }
}

/// One class' histograms, as lines over 0..255, scaled to a share of pixels.
cv::Mat draw(const ColourStatistics& seen, const std::string& title) {
  constexpr int kWidth = 420, kHeight = 170, kTop = 28, kBottom = 20;
  constexpr double kMostShare = 0.04;
  cv::Mat chart(kHeight, kWidth, CV_8UC3, kPaper.bgr());
  cv::putText(chart, title, {10, 18}, cv::FONT_HERSHEY_SIMPLEX, 0.45, kInk.bgr(), 1, cv::LINE_AA);
  cv::line(chart, {10, kHeight - kBottom}, {kWidth - 10, kHeight - kBottom}, kFaint.bgr());
  const double total = std::max(seen.total(), 1.0);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    std::vector<cv::Point> line;
    for (int value = 0; value < 256; value += 2) {
      const auto v = static_cast<std::size_t>(value);
      const double share = (seen.counts[channel][v] + seen.counts[channel][v + 1]) / 2.0 / total;
      line.emplace_back(10 + value * (kWidth - 20) / 256,
                        kHeight - kBottom -
                            static_cast<int>(std::min(share / kMostShare, 1.0) * (kHeight - kTop - kBottom)));
    }
    cv::polylines(chart, line, false, kChannelColors[channel].bgr(), 1, cv::LINE_AA);
  }
  return chart;
}

cv::Mat draw_all(const ByClass& real, const ByClass& rendered) {
  cv::Mat picture;
  for (std::size_t c = 0; c < kClassCount; ++c) {
    cv::Mat row;
    cv::hconcat(draw(real[c], fmt::format("{}: real", kClassNames[c])),
                draw(rendered[c], fmt::format("{}: rendered", kClassNames[c])), row);
    picture.empty() ? picture = row : (cv::vconcat(picture, row, picture), picture);
  }
  return picture;
}

}  // namespace

int run_colours_experiment(const ColoursExperiment& experiment) {
  const ExperimentOutput output(experiment.folder, "colours");
  const ByClass real = look_at_stills(experiment.stills);
  ByClass rendered;
  for (const std::string& course : experiment.courses) look_at_course(experiment, course, rendered);

  ResultTable table{{"class", "channel", "real: mean, deviation", "rendered: mean, deviation"}, {}};
  nlohmann::ordered_json result;
  for (std::size_t c = 0; c < kClassCount; ++c) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto text = [k](const ColourStatistics& s) {
        return fmt::format("{:.0f}, {:.0f}", s.mean(k), s.deviation(k));
      };
      table.rows.push_back({kClassNames[c], kChannelNames[k], text(real[c]), text(rendered[c])});
      const auto numbers = [k](const ColourStatistics& s) { return std::array{s.mean(k), s.deviation(k)}; };
      result[kClassNames[c]][kChannelNames[k]] = {{"real", numbers(real[c])},
                                                  {"rendered", numbers(rendered[c])}};
    }
  }
  cv::imwrite(output.path(".png"), draw_all(real, rendered));
  output.write(result, table.markdown());
  fmt::print("{}", table.markdown());
  return kExitOk;
}

}  // namespace hindsight::tools
