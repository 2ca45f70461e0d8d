// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What the colours of a label image mean for road following: tables in TOML (config/labels/).
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <unordered_map>
#include <vector>

#include "config/params.h"
#include "sim_replay/world/world.h"

namespace hindsight::tools {

struct RoadLabelParams {
  std::vector<std::string> road;
  std::vector<std::string> other;
  std::vector<std::string> ignored;

  void visit(auto&& param) {
    param("road", road, AnyText{}, "colours of road, each as \"#rrggbb\"");
    param("other", other, AnyText{}, "all further colours that occur");
    param("ignored", ignored, AnyText{}, "colours of pixels that do not count");
  }
};

/// Values of a truth mask.
enum class RoadTruthPixel : std::uint8_t { other = 0, road = 1, ignored = 2 };

class RoadLabelTable {
 public:
  /// FatalError(kExitConfiguration) naming `name` for a colour that is not "#rrggbb", or no colour of road.
  RoadLabelTable(const RoadLabelParams& params, std::string name);

  const std::string& name() const { return name_; }
  /// Share of an 8-bit BGR label image's pixels whose colour the table names.
  double known_share(const cv::Mat& labels_bgr) const;
  /// 8-bit mask of RoadTruthPixel; a colour that the table does not name is `other`.
  cv::Mat mask(const cv::Mat& labels_bgr) const;

 private:
  std::string name_;
  std::unordered_map<std::uint32_t, RoadTruthPixel> meaning_;
};

/// From a file of the user's. FatalError as RoadLabelTable and read_configuration.
RoadLabelTable load_label_table(const std::string& file);

/// The tables of config/labels/.
std::vector<RoadLabelTable> builtin_label_tables();

/// Text of the table of the simulator's labels, and their colours, B, G, R.
std::string simulator_label_table();
cv::Vec3b color_of(TruthLabel label);

}  // namespace hindsight::tools
