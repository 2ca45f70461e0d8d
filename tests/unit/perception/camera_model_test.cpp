// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/camera_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <opencv2/calib3d.hpp>
#include <random>

#include "config/exit_code.h"

namespace hindsight {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kIntrinsics =
    "image_width: 640\n"
    "image_height: 400\n"
    "camera_matrix:\n  rows: 3\n  cols: 3\n  data: [410.5, 0.0, 320.25, 0.0, 405.0, 199.5, 0.0, 0.0, 1.0]\n";
const std::string kDistortion =
    "distortion_model: plumb_bob\n"
    "distortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [-0.31, 0.11, 0.0007, -0.0004, -0.018]\n";
const std::string kMounting = "p_BC_m: [0.2, -0.1, 1.1]\ncamera_pitch_rad: 0.3\n";

CameraModel distorted_camera() {
  return parse_camera_model(kIntrinsics + kDistortion + kMounting, "test.yaml");
}

std::string error_of(const std::string& yaml, ExitCode code = kExitBadData) {
  try {
    parse_camera_model(yaml, "test.yaml");
  } catch (const FatalError& error) {
    EXPECT_EQ(error.code(), code);
    return error.what();
  }
  return "no error";
}

TEST(CameraModel, ReadsRosCalibration) {
  const CameraModel camera = distorted_camera();
  EXPECT_EQ(camera.width_px, 640);
  EXPECT_EQ(camera.height_px, 400);
  EXPECT_EQ(camera.fx_px, 410.5);
  EXPECT_EQ(camera.fy_px, 405.0);
  EXPECT_EQ(camera.cx_px, 320.25);
  EXPECT_EQ(camera.cy_px, 199.5);
  EXPECT_EQ(camera.distortion[4], -0.018);
  EXPECT_EQ(camera.p_BC_m, Eigen::Vector3d(0.2, -0.1, 1.1));
}

TEST(CameraModel, ReadsWhatOpenCvWrites) {
  cv::FileStorage out(".yml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  out << "image_width" << 720 << "image_height" << 480;
  out << "camera_matrix" << (cv::Mat_<double>(3, 3) << 420.125, 0, 360, 0, 421, 240, 0, 0, 1);
  out << "distortion_coefficients" << (cv::Mat_<double>(1, 8) << 1, 2, 3, 4, 5, 6, 7, 8);
  const CameraModel camera = parse_camera_model(out.releaseAndGetString() + kMounting, "opencv");
  EXPECT_EQ(camera.fx_px, 420.125);
  EXPECT_EQ(camera.distortion, (std::array<double, 8>{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(CameraModel, ReadsTheShippedCalibration) {
  const CameraModel camera =
      read_camera_model(std::filesystem::path(HINDSIGHT_SOURCE_DIR) / "config/camera.yaml");
  EXPECT_NO_THROW(camera.require_size(720, 480));
  // The upper half of a traffic cone at the bumper, left and right, is in the picture.
  for (const double y_m : {-0.3, 0.3}) {
    for (const double z_m : {0.35, 0.7}) {
      const auto pixel = camera.project({0.45, y_m, z_m});
      ASSERT_TRUE(pixel);
      EXPECT_GE(pixel->x_px, 0);
      EXPECT_LT(pixel->x_px, 720);
      EXPECT_GE(pixel->y_px, 0);
      EXPECT_LT(pixel->y_px, 480);
    }
  }
}

TEST(CameraModel, AnglesHaveTheSignsThatTheyClaim) {
  CameraModel camera = distorted_camera();
  camera.p_BC_m = {0, 0, 1};
  const auto column_of = [&](double y_m) { return camera.project({5, y_m, 1})->x_px; };
  const auto row_of = [&](double y_m) { return camera.project({5, y_m, 1})->y_px; };
  camera.set_orientation(0, 0, 0);
  const double level_row = row_of(0), straight_column = column_of(0);
  EXPECT_LT(column_of(0.5), straight_column) << "+y is left";
  camera.set_orientation(0, 0.1, 0);
  EXPECT_LT(row_of(0), level_row) << "looking down moves the world up";
  camera.set_orientation(0, 0, 0.1);
  EXPECT_GT(column_of(0), straight_column) << "looking left moves the world right";
  camera.set_orientation(0.1, 0, 0);
  EXPECT_GT(row_of(1), row_of(-1)) << "right side down turns the world counter-clockwise, its left side down";
}

TEST(CameraModel, ProjectsAsOpenCv) {
  const CameraModel camera = distorted_camera();
  const cv::Matx33d k(camera.fx_px, 0, camera.cx_px, 0, camera.fy_px, camera.cy_px, 0, 0, 1);
  const std::vector<double> d(camera.distortion.begin(), camera.distortion.end());
  std::mt19937 random(1);  // seed 1
  std::uniform_real_distribution<double> tangent(-0.55, 0.55), depth_m(0.5, 20);
  for (int n = 0; n < 1000; ++n) {
    const double z = depth_m(random);
    const Eigen::Vector3d p_CP_m(tangent(random) * z, tangent(random) * 0.6 * z, z);
    std::vector<cv::Point2d> expected;
    cv::projectPoints(std::vector<cv::Point3d>{{p_CP_m.x(), p_CP_m.y(), p_CP_m.z()}}, cv::Vec3d(),
                      cv::Vec3d(), k, d, expected);
    const auto pixel = camera.project(camera.R_BC * p_CP_m + camera.p_BC_m);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x_px, expected[0].x, 1e-8);
    EXPECT_NEAR(pixel->y_px, expected[0].y, 1e-8);
  }
}

TEST(CameraModel, RayGoesThroughItsPixelAgain) {
  const CameraModel camera = distorted_camera();
  for (int y = 0; y < camera.height_px; y += 13) {
    for (int x = 0; x < camera.width_px; x += 13) {
      const auto pixel = camera.project(camera.p_BC_m + 3.0 * camera.ray_B({double(x), double(y)}));
      ASSERT_TRUE(pixel);
      EXPECT_NEAR(pixel->x_px, x, 1e-6);
      EXPECT_NEAR(pixel->y_px, y, 1e-6);
    }
  }
}

TEST(CameraModel, WhatIsFarOutOfViewStaysOut) {
  // k1 < 0 folds back at tan = 1.04 here; without care, a point far to the side would land in the picture.
  const CameraModel camera = distorted_camera();
  for (double tangent = 1.0; tangent < 20.0; tangent *= 1.1) {
    const auto pixel = camera.project(camera.p_BC_m + camera.R_BC * Eigen::Vector3d(tangent, 0, 1));
    ASSERT_TRUE(pixel);
    EXPECT_GT(pixel->x_px, camera.width_px - 1);
  }
  EXPECT_FALSE(camera.project(camera.p_BC_m - camera.R_BC.col(2))) << "behind";
}

TEST(CameraModel, PatchesAreReadByName) {
  const CameraModel camera = parse_camera_model(
      kIntrinsics + kDistortion + kMounting + "patches:\n   ir_right: [ 600, 380, 40, 20 ]\n", "test.yaml");
  EXPECT_EQ(camera.patches[std::size_t(NearPatch::ir_right)], (ImageRect{600, 380, 40, 20}));
  EXPECT_FALSE(camera.patches[std::size_t(NearPatch::ir_left)]);
}

TEST(CameraModel, ErrorsNameFileKeyAndWhatIsExpected) {
  const auto says = [](const std::string& key, const std::string& expected) {
    return AllOf(HasSubstr("test.yaml"), HasSubstr("'" + key + "'"), HasSubstr("expected"),
                 HasSubstr(expected));
  };
  EXPECT_THAT(error_of(kDistortion + kMounting), says("image_width", "whole number"));
  EXPECT_THAT(error_of("image_width: 640.5\nimage_height: 400\n"), says("image_width", "whole number"));
  EXPECT_THAT(error_of("image_width: 640\nimage_height: 400\n" + kMounting), says("camera_matrix", "3 x 3"));
  EXPECT_THAT(
      error_of(
          "image_width: 640\nimage_height: 400\ncamera_matrix: { data: [1, 0, 0, 0, -1, 0, 0, 0, 1] }\n"),
      says("camera_matrix", "above 0"));
  EXPECT_THAT(error_of(kIntrinsics + kMounting), says("distortion_coefficients", "4, 5 or 8"));
  EXPECT_THAT(error_of(kIntrinsics + "distortion_coefficients: { data: [0, 0, 0] }\n"),
              says("distortion_coefficients", "8"));
  EXPECT_THAT(error_of(kIntrinsics + "distortion_model: equidistant\n"),
              says("distortion_model", "plumb_bob"));
  EXPECT_THAT(error_of(kIntrinsics + kDistortion), says("p_BC_m", "metres"));
  EXPECT_THAT(error_of(kIntrinsics + kDistortion + "p_BC_m: [0, 0, -1]\n"), says("p_BC_m", "z above 0"));
  EXPECT_THAT(error_of(kIntrinsics + kDistortion + "p_BC_m: [0, 0, 1]\n"),
              says("camera_pitch_rad", "radians"));
  EXPECT_THAT(error_of(kIntrinsics + kDistortion + "p_BC_m: [0, 0, 1]\ncamera_pitch_rad: 20\n"),
              says("camera_pitch_rad", "pi"));
  const std::string good = kIntrinsics + kDistortion + kMounting;
  EXPECT_THAT(error_of(good + "patches: { bumper: [0, 0, 9, 9] }\n"), says("patches.bumper", "bumper_left"));
  EXPECT_THAT(error_of(good + "patches: { ahead: [630, 0, 20, 9] }\n"), says("patches.ahead", "640 x 400"));
  EXPECT_THAT(error_of(good + "patches: 7\n"), says("patches", "map"));
  EXPECT_THAT(error_of("a: [1, 2"), AllOf(HasSubstr("test.yaml"), HasSubstr("YAML")));
}

TEST(CameraModel, MissingFileIsNoInput) {
  for (const char* path : {"/nowhere/camera.yaml", "/tmp"}) {
    try {
      read_camera_model(path);
      FAIL();
    } catch (const FatalError& error) {
      EXPECT_EQ(error.code(), kExitNoInput);
      EXPECT_THAT(error.what(), AllOf(HasSubstr(path), HasSubstr("calibration")));
    }
  }
}

TEST(CameraModel, OtherPictureSizeIsRefused) {
  const CameraModel camera = distorted_camera();
  EXPECT_NO_THROW(camera.require_size(640, 400));
  try {
    camera.require_size(1242, 375);
    FAIL();
  } catch (const FatalError& error) {
    EXPECT_EQ(error.code(), kExitBadData);
    EXPECT_THAT(error.what(), AllOf(HasSubstr("test.yaml"), HasSubstr("640 x 400"), HasSubstr("1242 x 375")));
  }
}

}  // namespace
}  // namespace hindsight
