// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/road_labels.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <utility>

#include "config/configuration.h"
#include "config/exit_code.h"
#include "tools/embedded_labels.h"

namespace hindsight::tools {
namespace {

/// In the order in which they are built in (tools/CMakeLists.txt).
constexpr std::array kLabelTableNames{"ycor.toml", "camvid.toml", "kitti_road.toml", "mask.toml",
                                      "simulator.toml"};
static_assert(kLabelTableNames.size() == kLabelTables.size());

struct LabelFile {
  RoadLabelParams labels;
  void visit(auto&& section) { section("labels", labels); }
};

std::uint32_t key_of(const cv::Vec3b& bgr) {
  return static_cast<std::uint32_t>(bgr[2]) << 16U | static_cast<std::uint32_t>(bgr[1]) << 8U | bgr[0];
}

std::uint32_t parse_color(const std::string& text, const std::string& name) {
  std::uint32_t value = 0;
  const char* end = text.data() + text.size();
  const bool shaped = text.size() == 7 && text.front() == '#';
  if (!shaped || std::from_chars(text.data() + 1, end, value, 16).ptr != end) {
    throw FatalError(kExitConfiguration,
                     fmt::format("{}: \"{}\" is not a colour; expected \"#rrggbb\"", name, text));
  }
  return value;
}

RoadLabelTable parse_label_table(const ConfigDocument& document) {
  LabelFile file;
  read_configuration(file, document);
  return {file.labels, document.file_name};
}

}  // namespace

RoadLabelTable::RoadLabelTable(const RoadLabelParams& params, std::string name) : name_(std::move(name)) {
  if (params.road.empty())
    throw FatalError(kExitConfiguration, name_ + ": labels.road is empty; expected the colours of road");
  for (const std::string& color : params.other) meaning_[parse_color(color, name_)] = RoadTruthPixel::other;
  for (const std::string& color : params.ignored)
    meaning_[parse_color(color, name_)] = RoadTruthPixel::ignored;
  for (const std::string& color : params.road) meaning_[parse_color(color, name_)] = RoadTruthPixel::road;
}

double RoadLabelTable::known_share(const cv::Mat& labels_bgr) const {
  std::size_t known = 0;
  for (auto pixel = labels_bgr.begin<cv::Vec3b>(); pixel != labels_bgr.end<cv::Vec3b>(); ++pixel)
    known += meaning_.contains(key_of(*pixel)) ? 1U : 0U;
  return static_cast<double>(known) / static_cast<double>(labels_bgr.total());
}

cv::Mat RoadLabelTable::mask(const cv::Mat& labels_bgr) const {
  cv::Mat mask(labels_bgr.size(), CV_8U);
  auto to = mask.begin<std::uint8_t>();
  for (auto pixel = labels_bgr.begin<cv::Vec3b>(); pixel != labels_bgr.end<cv::Vec3b>(); ++pixel, ++to) {
    const auto found = meaning_.find(key_of(*pixel));
    *to = static_cast<std::uint8_t>(found == meaning_.end() ? RoadTruthPixel::other : found->second);
  }
  return mask;
}

RoadLabelTable load_label_table(const std::string& file) {
  return parse_label_table(ConfigDocument::load(file));
}

std::vector<RoadLabelTable> builtin_label_tables() {
  std::vector<RoadLabelTable> tables;
  for (std::size_t i = 0; i < kLabelTables.size(); ++i)
    tables.push_back(parse_label_table(ConfigDocument::parse(kLabelTables[i], kLabelTableNames[i])));
  return tables;
}

std::string simulator_label_table() { return kLabelTables.back(); }

cv::Vec3b color_of(TruthLabel label) {
  switch (label) {
    case TruthLabel::sky:
      return {0xff, 0xb7, 0x6f};
    case TruthLabel::ground:
      return {0x73, 0x7f, 0x8a};
    case TruthLabel::tree:
      return {0x2a, 0x5d, 0x2f};
    case TruthLabel::bush:
      return {0x3c, 0x8f, 0x6a};
    case TruthLabel::fence:
      return {0x1a, 0x7a, 0xff};
    case TruthLabel::road:
      return {0x6b, 0x9a, 0xb2};
    case TruthLabel::rock:
      return {0x5a, 0x5a, 0x5a};
  }
  return {};
}

}  // namespace hindsight::tools
