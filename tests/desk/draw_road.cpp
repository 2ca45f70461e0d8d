// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// draw_road DIR COUNT: pictures of a drive along a gravel road between grass verges under a plain sky, for
// machines that have no recording. Same camera as tests/desk/camera.yaml, level, 0.12 m further with each
// picture.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>

namespace {

constexpr int kWidth_px = 720;
constexpr int kHeight_px = 480;
constexpr double kFx_px = 418.28;
constexpr double kFy_px = 923.57;
constexpr double kCx_px = 353.37;
constexpr double kCy_px = 221.25;
constexpr double kCameraHeight_m = 1.65;
constexpr double kStep_m = 0.12;

// A number in [0, 1) that looks random but depends on the lattice point only.
double lattice(int x, int z) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 374761393U + static_cast<std::uint32_t>(z) * 668265263U;
  h = (h ^ (h >> 13U)) * 1274126177U;
  return static_cast<double>((h ^ (h >> 16U)) & 0xFFFFU) / 65536.0;
}

// Value noise: the lattice's numbers, blended between its points.
double noise(double x, double z) {
  const int ix = static_cast<int>(std::floor(x));
  const int iz = static_cast<int>(std::floor(z));
  const double fx = x - ix;
  const double fz = z - iz;
  return std::lerp(std::lerp(lattice(ix, iz), lattice(ix + 1, iz), fx),
                   std::lerp(lattice(ix, iz + 1), lattice(ix + 1, iz + 1), fx), fz);
}

cv::Vec3b ground_colour(double right_m, double forward_m) {
  const double coarse = noise(right_m * 1.5, forward_m * 1.5);
  const double fine = noise(right_m * 12.0, forward_m * 12.0);
  const double shade = 0.6 + 0.25 * coarse + 0.35 * fine;
  const bool road = std::abs(right_m + 0.4 * (coarse - 0.5)) < 1.6;
  const cv::Vec3d colour = road ? cv::Vec3d(115, 130, 140) : cv::Vec3d(45, 125, 85);
  return cv::Vec3b(colour * shade);
}

cv::Mat draw(double travelled_m) {
  cv::Mat picture(kHeight_px, kWidth_px, CV_8UC3, cv::Scalar(235, 205, 170));
  for (int v = static_cast<int>(kCy_px) + 2; v < kHeight_px; ++v) {
    const double forward_m = kCameraHeight_m * kFy_px / (v - kCy_px);
    for (int u = 0; u < kWidth_px; ++u) {
      const double right_m = (u - kCx_px) * forward_m / kFx_px;
      picture.at<cv::Vec3b>(v, u) = ground_colour(right_m, forward_m + travelled_m);
    }
  }
  return picture;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "draw_road DIR COUNT\n");
    return 64;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  for (int i = 0; i < std::atoi(argv[2]); ++i) {
    char name[16];
    std::snprintf(name, sizeof name, "%06d.jpg", i);
    if (!cv::imwrite((folder / name).string(), draw(i * kStep_m))) return 74;
  }
}
