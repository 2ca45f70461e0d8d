// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <map>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/road_frames.h"
#include "tools/road_labels.h"

namespace hindsight::tools {

/// Where the road truly is in some frames: label images, or polygons outlined by hand.
///
/// A frame's label image is the picture whose stem is the frame's name, or begins with it and goes on with
/// one of
/// "_-.", or which lies in a folder of that name and is not the frame itself. Polygons are in polygons.json:
/// {"width": 1242, "height": 375, "polygons": {"NAME": [[x, y], ...]}}.
class RoadTruth {
 public:
  /// `label_table`: a file, or empty for labels.toml in the folder, else for the built-in table that knows
  /// nearly all colours of the first label image. FatalError: kExitNoInput where the folder cannot be read,
  /// or no frame has truth; kExitBadData where no table fits or polygons.json is damaged; as
  /// load_label_table.
  RoadTruth(const std::filesystem::path& folder, const std::vector<RoadFrameFile>& frames,
            const std::string& label_table);

  bool has(const std::string& frame) const { return labels_.contains(frame) || polygons_.contains(frame); }
  std::size_t size() const { return labels_.size() + polygons_.size(); }
  /// RoadTruthPixel of each pixel of a frame of that size; FatalError(kExitBadData) for a label image that
  /// cannot be decoded.
  cv::Mat mask(const std::string& frame, cv::Size size) const;

 private:
  void find_labels(const std::filesystem::path& folder, const std::vector<RoadFrameFile>& frames);
  void read_polygons(const std::filesystem::path& file, const std::vector<RoadFrameFile>& frames);
  void choose_table(const std::filesystem::path& folder, const std::string& label_table);

  std::map<std::string, std::filesystem::path> labels_;
  std::map<std::string, std::vector<cv::Point2d>> polygons_;
  cv::Size polygon_size_;
  std::optional<RoadLabelTable> table_;
};

}  // namespace hindsight::tools
