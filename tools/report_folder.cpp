// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_folder.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <utility>
#include <vector>

#include "config/exit_code.h"

namespace hindsight::tools {
namespace {

constexpr int kJpegQuality = 88;

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw FatalError(kExitIo, path.string() + ": cannot be written: " + std::strerror(errno));
}

}  // namespace

ReportFolder::ReportFolder(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) throw FatalError(kExitIo, path_.string() + ": the folder cannot be made: " + error.message());
}

void ReportFolder::write_picture(const std::string& name, const cv::Mat& bgr) const {
  std::vector<std::uint8_t> bytes;
  cv::imencode(std::filesystem::path(name).extension().string(), bgr, bytes,
               {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  write_text(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void ReportFolder::write_text(const std::string& name, std::string_view text) const {
  const std::filesystem::path file = path_ / name;
  std::ofstream out(file, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) fail(file);
}

}  // namespace hindsight::tools
