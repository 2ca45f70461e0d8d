// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The folder that a report is written to.
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <string_view>

namespace hindsight::tools {

class ReportFolder {
 public:
  /// Makes the folder. FatalError 74 where that is not possible.
  explicit ReportFolder(std::filesystem::path path);

  /// The ending of `name` chooses the format. FatalError 74 where it cannot be written.
  void write_picture(const std::string& name, const cv::Mat& bgr) const;
  void write_text(const std::string& name, std::string_view text) const;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace hindsight::tools
