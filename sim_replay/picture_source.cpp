// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/picture_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <vector>

#include "config/exit_code.h"
#include "sim_replay/jpeg_header.h"
#include "sim_replay/read_file.h"

namespace hindsight {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_picture(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".jpg" || extension == ".jpeg" || extension == ".png";
}

/// A name by which text sorts as numbers do: every run of digits without leading zeros, after its length.
std::string number_key(const std::string& stem) {
  std::string key;
  for (std::size_t i = 0; i < stem.size();) {
    if (!is_digit(stem[i])) {
      key += stem[i++];
      continue;
    }
    std::size_t end = i;
    while (end < stem.size() && is_digit(stem[end])) ++end;
    while (i + 1 < end && stem[i] == '0') ++i;
    key += fmt::format("{:03}", end - i);
    key.append(stem, i, end - i);
    i = end;
  }
  return key;
}

struct NumberedPicture {
  std::string key;
  fs::path path;
  auto operator<=>(const NumberedPicture&) const = default;
};

std::vector<NumberedPicture> list_pictures(const fs::path& folder) {
  std::vector<NumberedPicture> pictures;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (!entry.is_regular_file() || !is_picture(entry.path())) continue;
    const std::string stem = entry.path().stem().string();
    if (std::none_of(stem.begin(), stem.end(), is_digit)) {
      throw FatalError(kExitBadData,
                       fmt::format("{}: a picture without a number in its name", entry.path().string()));
    }
    pictures.push_back({number_key(stem), entry.path()});
  }
  if (pictures.empty()) {
    throw FatalError(kExitNoInput,
                     fmt::format("{}: no pictures (.jpg, .jpeg, .png) in this folder", folder.string()));
  }
  std::sort(pictures.begin(), pictures.end());
  const auto twice = std::adjacent_find(pictures.begin(), pictures.end(),
                                        [](const auto& a, const auto& b) { return a.key == b.key; });
  if (twice != pictures.end()) {
    throw FatalError(kExitBadData,
                     fmt::format("{}: has the same number as {}", std::next(twice)->path.string(),
                                 twice->path.filename().string()));
  }
  return pictures;
}

void set_picture(const cv::Mat& bgr, Frame& frame) {
  frame.format = PixelFormat::bgr24;
  frame.width_px = bgr.cols;
  frame.height_px = bgr.rows;
  frame.bytes.assign(bgr.datastart, bgr.dataend);
}

class FolderPictures : public PictureSource {
 public:
  explicit FolderPictures(const fs::path& folder) : pictures_(list_pictures(folder)) {}

  bool next(Frame& frame) override {
    if (next_ >= pictures_.size()) return false;
    const std::string path = pictures_[next_++].path.string();
    frame.bytes = read_file<std::vector<std::uint8_t>>(path);
    const auto jpeg = read_jpeg_header(frame.bytes);
    if (jpeg && jpeg->baseline_colour) {
      frame.format = PixelFormat::mjpeg;
      frame.width_px = jpeg->width_px;
      frame.height_px = jpeg->height_px;
    } else {
      set_picture(decode(frame.bytes, path, jpeg.has_value()), frame);
    }
    return true;
  }
  std::string name() const override { return pictures_[next_ == 0 ? 0 : next_ - 1].path.string(); }
  std::uint64_t count() const override { return pictures_.size(); }

 private:
  static cv::Mat decode(const std::vector<std::uint8_t>& bytes, const std::string& path, bool whole_jpeg) {
    const bool cut_jpeg = !whole_jpeg && bytes.size() >= 2 && bytes[0] == 0xFF && bytes[1] == 0xD8;
    cv::Mat picture;
    // The camera's pixels are wanted as they lie, whichever way up somebody held it.
    if (!bytes.empty() && !cut_jpeg)
      picture = cv::imdecode(bytes, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
    if (picture.empty())
      throw FatalError(kExitBadData, fmt::format("{}: not a whole JPEG or PNG picture", path));
    return picture;
  }

  std::vector<NumberedPicture> pictures_;
  std::size_t next_ = 0;
};

class VideoPictures : public PictureSource {
 public:
  explicit VideoPictures(const fs::path& path) : path_(path.string()), video_(path_, cv::CAP_FFMPEG) {
    if (!video_.isOpened())
      throw FatalError(kExitBadData, fmt::format("{}: not a video that can be decoded", path_));
  }

  bool next(Frame& frame) override {
    if (!video_.read(picture_)) return false;
    ++done_;
    cv::imencode(".jpg", picture_, frame.bytes, {cv::IMWRITE_JPEG_QUALITY, 95});
    frame.format = PixelFormat::mjpeg;
    frame.width_px = picture_.cols;
    frame.height_px = picture_.rows;
    return true;
  }
  std::string name() const override { return fmt::format("{}, frame {}", path_, done_ == 0 ? 0 : done_ - 1); }
  std::uint64_t count() const override {
    const double frames = video_.get(cv::CAP_PROP_FRAME_COUNT);
    return frames > 0.0 && frames < 1e9 ? static_cast<std::uint64_t>(std::llround(frames)) : 0;
  }

 private:
  std::string path_;
  cv::VideoCapture video_;
  cv::Mat picture_;
  std::uint64_t done_ = 0;
};

}  // namespace

std::unique_ptr<PictureSource> open_pictures(const fs::path& path) {
  if (fs::is_directory(path)) return std::make_unique<FolderPictures>(path);
  if (!fs::exists(path))
    throw FatalError(kExitNoInput, fmt::format("{}: no such folder or video", path.string()));
  return std::make_unique<VideoPictures>(path);
}

}  // namespace hindsight
