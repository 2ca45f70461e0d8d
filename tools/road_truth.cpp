// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/road_truth.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "config/exit_code.h"

namespace hindsight::tools {
namespace {

namespace fs = std::filesystem;

/// A table that knows fewer of a label image's pixels than this is another data set's.
constexpr double kKnowsNearlyAll = 0.98;

cv::Mat read_labels(const fs::path& file) {
  cv::Mat labels = cv::imread(file.string(), cv::IMREAD_COLOR);
  if (labels.empty())
    throw FatalError(kExitBadData, fmt::format("{}: label image cannot be decoded", file.string()));
  return labels;
}

}  // namespace

RoadTruth::RoadTruth(const fs::path& folder, const std::vector<RoadFrameFile>& frames,
                     const std::string& label_table) {
  find_labels(folder, frames);
  if (const fs::path file = folder / "polygons.json"; fs::exists(file)) read_polygons(file, frames);
  if (size() == 0) {
    throw FatalError(
        kExitNoInput,
        fmt::format("{}: no truth for any of the {} frames ({} to {}); expected label images named as "
                    "they are, or polygons.json",
                    folder.string(), frames.size(), frames.front().name, frames.back().name));
  }
  if (!labels_.empty()) choose_table(folder, label_table);
}

void RoadTruth::find_labels(const fs::path& folder, const std::vector<RoadFrameFile>& frames) {
  std::map<std::string, const RoadFrameFile*> by_name;
  for (const RoadFrameFile& frame : frames) by_name[frame.name] = &frame;
  const auto take = [&](const std::string& name, const fs::path& picture) {
    const auto frame = by_name.find(name);
    if (frame == by_name.end() || fs::equivalent(frame->second->file, picture)) return false;
    return labels_.emplace(name, picture).second;
  };
  for (const fs::path& picture : find_pictures(folder)) {
    const std::string stem = picture.stem().string();
    if (take(stem, picture) || take(picture.parent_path().filename().string(), picture)) continue;
    for (std::size_t cut = stem.find_last_of("_-."); cut != std::string::npos && cut > 0;
         cut = stem.find_last_of("_-.", cut - 1)) {
      if (take(stem.substr(0, cut), picture)) break;
    }
  }
}

void RoadTruth::read_polygons(const fs::path& file, const std::vector<RoadFrameFile>& frames) {
  std::ifstream in(file);
  try {
    const nlohmann::json json = nlohmann::json::parse(in);
    polygon_size_ = {json.at("width").get<int>(), json.at("height").get<int>()};
    for (const RoadFrameFile& frame : frames) {
      const auto found = json.at("polygons").find(frame.name);
      if (found == json.at("polygons").end()) continue;
      std::vector<cv::Point2d> polygon;
      for (const auto& point : *found)
        polygon.emplace_back(point.at(0).get<double>(), point.at(1).get<double>());
      if (polygon.size() < 3)
        throw FatalError(kExitBadData,
                         fmt::format("{}: {}: a polygon has at least 3 points", file.string(), frame.name));
      polygons_[frame.name] = std::move(polygon);
    }
  } catch (const nlohmann::json::exception& error) {
    throw FatalError(kExitBadData, fmt::format("{}: {}", file.string(), error.what()));
  }
}

void RoadTruth::choose_table(const fs::path& folder, const std::string& label_table) {
  if (!label_table.empty()) {
    table_ = load_label_table(label_table);
    return;
  }
  if (fs::exists(folder / "labels.toml")) {
    table_ = load_label_table((folder / "labels.toml").string());
    return;
  }
  const fs::path& first = labels_.begin()->second;
  const cv::Mat labels = read_labels(first);
  double best = kKnowsNearlyAll;
  for (RoadLabelTable& table : builtin_label_tables()) {
    const double known = table.known_share(labels);
    if (known < best) continue;
    best = known;
    table_ = std::move(table);
  }
  if (!table_) {
    throw FatalError(
        kExitBadData,
        fmt::format("{}: no built-in table knows its colours; give one with --labels, or as labels.toml "
                    "beside the label images",
                    first.string()));
  }
}

cv::Mat RoadTruth::mask(const std::string& frame, cv::Size size) const {
  cv::Mat mask;
  if (const auto labels = labels_.find(frame); labels != labels_.end()) {
    mask = table_->mask(read_labels(labels->second));
    if (mask.size() != size) cv::resize(mask, mask, size, 0.0, 0.0, cv::INTER_NEAREST);
    return mask;
  }
  std::vector<cv::Point> points;
  for (const cv::Point2d& p : polygons_.at(frame)) {
    points.emplace_back(static_cast<int>(std::lround(p.x * size.width / polygon_size_.width)),
                        static_cast<int>(std::lround(p.y * size.height / polygon_size_.height)));
  }
  mask = cv::Mat::zeros(size, CV_8U);
  cv::fillPoly(mask, std::vector{points}, static_cast<double>(RoadTruthPixel::road));
  return mask;
}

}  // namespace hindsight::tools
