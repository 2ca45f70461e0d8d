// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/road_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "config/exit_code.h"

namespace hindsight::tools {
namespace {

namespace fs = std::filesystem;

bool is_picture(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".jpg" || extension == ".jpeg" || extension == ".png" || extension == ".ppm" ||
         extension == ".bmp" || extension == ".tif" || extension == ".tiff";
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// "frame9" before "frame10".
bool before_by_number(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (is_digit(a[i]) && is_digit(b[j])) {
      const auto number = [](const std::string& text, std::size_t& at) {
        const std::size_t begin = at;
        while (at < text.size() && is_digit(text[at])) ++at;
        const std::size_t first = std::min(text.find_first_not_of('0', begin), at);
        return text.substr(first, at - first);
      };
      const std::string x = number(a, i), y = number(b, j);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
    } else if (a[i] != b[j]) {
      return a[i] < b[j];
    } else {
      ++i, ++j;
    }
  }
  return a.size() - i < b.size() - j;
}

std::vector<fs::directory_entry> entries_of(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::directory_entry> entries;
  for (const auto& entry : fs::directory_iterator(folder, error)) entries.push_back(entry);
  if (error)
    throw FatalError(kExitNoInput,
                     fmt::format("{}: cannot be read as a folder: {}", folder.string(), error.message()));
  return entries;
}

bool is_label(const std::string& stem, const std::set<std::string>& stems) {
  if (stem.starts_with("label")) return true;
  const std::size_t cut = stem.find_last_of("_-.");
  return cut != std::string::npos && cut > 0 && stems.contains(stem.substr(0, cut));
}

/// Of the pictures directly in a folder, those that are not labels.
std::vector<fs::path> frames_in(const fs::path& folder) {
  std::vector<fs::path> pictures;
  std::set<std::string> stems;
  for (const auto& entry : entries_of(folder)) {
    if (!entry.is_regular_file() || !is_picture(entry.path())) continue;
    pictures.push_back(entry.path());
    stems.insert(entry.path().stem().string());
  }
  std::erase_if(pictures, [&](const fs::path& file) { return is_label(file.stem().string(), stems); });
  return pictures;
}

}  // namespace

std::vector<RoadFrameFile> find_road_frames(const fs::path& folder) {
  std::vector<RoadFrameFile> frames;
  for (const fs::path& file : frames_in(folder)) frames.push_back({file.stem().string(), file});
  if (frames.empty()) {
    for (const auto& entry : entries_of(folder)) {
      if (!entry.is_directory()) continue;
      const std::vector<fs::path> inside = frames_in(entry.path());
      if (inside.size() == 1) frames.push_back({entry.path().filename().string(), inside.front()});
    }
  }
  if (frames.empty()) {
    throw FatalError(kExitNoInput,
                     fmt::format("{}: holds no frames; expected pictures (.jpg, .png), or folders with one "
                                 "picture each",
                                 folder.string()));
  }
  std::sort(frames.begin(), frames.end(),
            [](const RoadFrameFile& a, const RoadFrameFile& b) { return before_by_number(a.name, b.name); });
  return frames;
}

cv::Mat read_road_frame(const fs::path& file, cv::Size expected) {
  cv::Mat image = cv::imread(file.string(), cv::IMREAD_COLOR);
  if (image.empty()) {
    throw FatalError(kExitBadData,
                     fmt::format("{}: cannot be decoded; expected a whole JPEG or PNG", file.string()));
  }
  if (!expected.empty() && image.size() != expected) {
    throw FatalError(kExitBadData,
                     fmt::format("{}: is {} x {} pixels; expected {} x {} as the frames before it",
                                 file.string(), image.cols, image.rows, expected.width, expected.height));
  }
  return image;
}

std::vector<fs::path> find_pictures(const fs::path& folder) {
  std::vector<fs::path> pictures;
  for (const auto& entry : entries_of(folder)) {
    if (entry.is_directory()) {
      for (const auto& inner : entries_of(entry.path()))
        if (inner.is_regular_file() && is_picture(inner.path())) pictures.push_back(inner.path());
    } else if (is_picture(entry.path())) {
      pictures.push_back(entry.path());
    }
  }
  std::sort(pictures.begin(), pictures.end());
  return pictures;
}

}  // namespace hindsight::tools
