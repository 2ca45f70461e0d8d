// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/image_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "config/exit_code.h"

namespace hindsight::tools {
namespace {

bool is_picture(const std::filesystem::directory_entry& entry) {
  std::string extension = entry.path().extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return entry.is_regular_file() && (extension == ".jpg" || extension == ".jpeg" || extension == ".png");
}

}  // namespace

ImageFolder::ImageFolder(const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::directory_iterator entries(folder, error);
  if (error) {
    throw FatalError(kExitNoInput,
                     fmt::format("{}: cannot be read as a folder: {}", folder.string(), error.message()));
  }
  for (const auto& entry : entries) {
    if (is_picture(entry)) files_.push_back(entry.path());
  }
  if (files_.empty()) {
    throw FatalError(kExitNoInput,
                     fmt::format("{}: holds no picture; expected .jpg or .png files", folder.string()));
  }
  std::sort(files_.begin(), files_.end());
}

cv::Mat ImageFolder::read(int index) {
  const std::filesystem::path& file = files_[static_cast<std::size_t>(index)];
  cv::Mat image = cv::imread(file.string(), cv::IMREAD_COLOR);
  if (image.empty()) {
    throw FatalError(kExitBadData,
                     fmt::format("{}: cannot be decoded; expected a whole JPEG or PNG", file.string()));
  }
  if (!size_) size_ = image.size();
  if (image.size() != *size_) {
    throw FatalError(kExitBadData,
                     fmt::format("{}: is {} x {} pixels; expected {} x {} as in the pictures before it",
                                 file.string(), image.cols, image.rows, size_->width, size_->height));
  }
  return image;
}

}  // namespace hindsight::tools
