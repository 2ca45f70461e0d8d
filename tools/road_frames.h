// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Recorded frames and their truth, found by name.
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

namespace hindsight::tools {

struct RoadFrameFile {
  std::string name;  ///< what truth is found by: the file's stem, or its folder's name
  std::filesystem::path file;
};

/// The frames of a folder in the order of their names: its pictures, or, where it has none, one picture of
/// each folder in it (NAME/rgb.jpg, beside which NAME/labels.png may lie). Numbers in names count as numbers.
/// Pictures whose name is another one's with something added ("x_L.png" beside "x.png"), or begins with
/// "label", are labels and left out. FatalError(kExitNoInput) where the folder cannot be read or holds no
/// picture.
std::vector<RoadFrameFile> find_road_frames(const std::filesystem::path& folder);

/// 8-bit BGR; FatalError(kExitBadData) where it cannot be decoded or has another size than `expected` (if not
/// empty).
cv::Mat read_road_frame(const std::filesystem::path& file, cv::Size expected);

/// All pictures under a folder that may be labels: those in it, and in the folders in it.
std::vector<std::filesystem::path> find_pictures(const std::filesystem::path& folder);

}  // namespace hindsight::tools
