// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The calibration file's reader.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <fstream>
#include <opencv2/core/persistence.hpp>
#include <opencv2/core/utility.hpp>
#include <sstream>
#include <string_view>
#include <vector>

#include "config/exit_code.h"
#include "perception/camera_model.h"

namespace hindsight {
namespace {

constexpr std::array<std::string_view, kNearPatchCount> kPatchNames = {
    "bumper_left", "bumper_right", "ir_left", "ir_right", "ahead", "bumper_both"};

/// OpenCV prints its errors before it throws them; ours are printed once, by whoever catches them.
class QuietOpenCv {
 public:
  QuietOpenCv()
      : previous_(
            cv::redirectError([](int, const char*, const char*, const char*, int, void*) { return 0; })) {}
  ~QuietOpenCv() { cv::redirectError(previous_); }
  QuietOpenCv(const QuietOpenCv&) = delete;
  QuietOpenCv& operator=(const QuietOpenCv&) = delete;

 private:
  cv::ErrorCallback previous_;
};

class Reader {
 public:
  Reader(const std::string& yaml, const std::string& name) : name_(name) {
    const QuietOpenCv quiet;
    // OpenCV wants its own header line, which ROS' files do not have.
    const std::string text = yaml.starts_with("%YAML") ? yaml : "%YAML:1.0\n---\n" + yaml;
    try {
      storage_.open(text, cv::FileStorage::READ | cv::FileStorage::MEMORY | cv::FileStorage::FORMAT_YAML);
    } catch (const cv::Exception& error) {
      throw FatalError(kExitBadData, fmt::format("{}: not a YAML calibration: {}", name_, error.err));
    }
    if (!storage_.isOpened())
      throw FatalError(kExitBadData, fmt::format("{}: empty, expected a YAML calibration", name_));
  }

  cv::FileNode node(const std::string& key) const { return storage_[key]; }

  [[noreturn]] void fail(std::string_view key, std::string_view expected) const {
    throw FatalError(kExitBadData, fmt::format("{}: key '{}': expected {}", name_, key, expected));
  }

  int size_px(const std::string& key) const {
    constexpr int kLargest_px = 16384;
    const cv::FileNode value = node(key);
    if (!value.isInt() || static_cast<int>(value) < 1 || static_cast<int>(value) > kLargest_px)
      fail(key,
           fmt::format("the calibrated pictures' size, a whole number of pixels from 1 to {}", kLargest_px));
    return static_cast<int>(value);
  }

  double angle_rad(const std::string& key, bool required) const {
    const cv::FileNode value = node(key);
    if (value.empty() && !required) return 0.0;
    const double angle = value.isReal() || value.isInt() ? static_cast<double>(value) : NAN;
    if (!(std::abs(angle) <= M_PI)) fail(key, "an angle in radians from -pi to pi");
    return angle;
  }

  std::vector<double> numbers(const std::string& key, const cv::FileNode& list,
                              std::string_view expected) const {
    std::vector<double> values;
    if (!list.isSeq()) fail(key, expected);
    for (const cv::FileNode& value : list) {
      if (!value.isReal() && !value.isInt()) fail(key, expected);
      values.push_back(static_cast<double>(value));
      if (!std::isfinite(values.back())) fail(key, expected);
    }
    return values;
  }

  /// The numbers of a matrix, tagged !!opencv-matrix or a plain map with `data`, as ROS has it.
  std::vector<double> matrix(const std::string& key, std::string_view expected) const {
    const cv::FileNode value = node(key);
    if (!value.isMap()) fail(key, expected);
    return numbers(key, value["data"], expected);
  }

 private:
  std::string name_;
  cv::FileStorage storage_;
};

void read_intrinsics(const Reader& reader, CameraModel& camera) {
  camera.width_px = reader.size_px("image_width");
  camera.height_px = reader.size_px("image_height");
  constexpr std::string_view kExpected = "a 3 x 3 matrix [fx 0 cx; 0 fy cy; 0 0 1] with fx and fy above 0";
  const std::vector<double> k = reader.matrix("camera_matrix", kExpected);
  if (k.size() != 9 || !(k[0] > 0) || !(k[4] > 0) || k[1] != 0 || k[3] != 0 || k[6] != 0 || k[7] != 0 ||
      k[8] != 1)
    reader.fail("camera_matrix", kExpected);
  camera.fx_px = k[0];
  camera.fy_px = k[4];
  camera.cx_px = k[2];
  camera.cy_px = k[5];
}

void read_distortion(const Reader& reader, CameraModel& camera) {
  const cv::FileNode model = reader.node("distortion_model");
  if (!model.empty() &&
      (!model.isString() || (model.string() != "plumb_bob" && model.string() != "rational_polynomial")))
    reader.fail("distortion_model", "plumb_bob or rational_polynomial (fisheye lenses are not supported)");
  constexpr std::string_view kExpected = "a matrix of 4, 5 or 8 numbers k1 k2 p1 p2 [k3 [k4 k5 k6]]";
  const std::vector<double> k = reader.matrix("distortion_coefficients", kExpected);
  if (k.size() != 4 && k.size() != 5 && k.size() != 8) reader.fail("distortion_coefficients", kExpected);
  std::copy(k.begin(), k.end(), camera.distortion.begin());
}

void read_mounting(const Reader& reader, CameraModel& camera) {
  constexpr std::string_view kExpected =
      "the camera's position on the vehicle, [x, y, z] in metres, with z above 0";
  const std::vector<double> p = reader.numbers("p_BC_m", reader.node("p_BC_m"), kExpected);
  if (p.size() != 3 || !(p[2] > 0)) reader.fail("p_BC_m", kExpected);
  camera.p_BC_m = {p[0], p[1], p[2]};
  camera.set_orientation(reader.angle_rad("camera_roll_rad", false),
                         reader.angle_rad("camera_pitch_rad", true),
                         reader.angle_rad("camera_yaw_rad", false));
}

void read_patch(const Reader& reader, const cv::FileNode& patch, CameraModel& camera) {
  const std::string key = "patches." + patch.name();
  const auto known = std::find(kPatchNames.begin(), kPatchNames.end(), patch.name());
  if (known == kPatchNames.end())
    reader.fail(key, fmt::format("one of the patches {}", fmt::join(kPatchNames, ", ")));
  const std::string expected = fmt::format("[x, y, width, height] in pixels, within the picture of {} x {}",
                                           camera.width_px, camera.height_px);
  const std::vector<double> r = reader.numbers(key, patch, expected);
  if (r.size() != 4 || r[0] < 0 || r[1] < 0 || !(r[2] >= 1) || !(r[3] >= 1) ||
      r[0] + r[2] > camera.width_px || r[1] + r[3] > camera.height_px)
    reader.fail(key, expected);
  camera.patches[static_cast<std::size_t>(known - kPatchNames.begin())] = ImageRect{
      static_cast<float>(r[0]), static_cast<float>(r[1]), static_cast<float>(r[2]), static_cast<float>(r[3])};
}

}  // namespace

CameraModel parse_camera_model(const std::string& yaml, const std::string& name) {
  const Reader reader(yaml, name);
  CameraModel camera;
  camera.name = name;
  read_intrinsics(reader, camera);
  read_distortion(reader, camera);
  read_mounting(reader, camera);
  camera.set_field_of_view();
  const cv::FileNode patches = reader.node("patches");
  if (!patches.empty() && !patches.isMap())
    reader.fail("patches", "a map from patch names to [x, y, width, height]");
  for (const cv::FileNode& patch : patches) read_patch(reader, patch, camera);
  return camera;
}

CameraModel read_camera_model(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!std::filesystem::is_regular_file(path) || !file || !(text << file.rdbuf()))
    throw FatalError(kExitNoInput,
                     fmt::format("{}: cannot be read, expected a camera calibration (YAML)", path.string()));
  return parse_camera_model(text.str(), path.string());
}

}  // namespace hindsight
