// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

namespace hindsight::tools {

/// The pictures (jpg, jpeg, png) of a folder as a sequence, in the order of their names.
class ImageFolder {
 public:
  /// Throws FatalError: kExitNoInput for a folder that is not there or holds no picture.
  explicit ImageFolder(const std::filesystem::path& folder);

  int size() const { return static_cast<int>(files_.size()); }

  /// 8-bit BGR. Throws FatalError, kExitBadData, for a picture that cannot be decoded or that differs in size
  /// from the first one that was read.
  cv::Mat read(int index);

 private:
  std::vector<std::filesystem::path> files_;
  std::optional<cv::Size> size_;
};

}  // namespace hindsight::tools
