// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_frame.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "tools/report_style.h"
#include "tools/report_tracks.h"
#include "tools/road_drawing.h"

namespace hindsight::tools {
namespace {

constexpr double kTint = 0.35;
constexpr int kSubPixelBits = 4;

cv::Point sub_pixel(double x_px, double y_px) {
  constexpr double scale = 1 << kSubPixelBits;
  return {static_cast<int>(std::lround(x_px * scale)), static_cast<int>(std::lround(y_px * scale))};
}

void tint_labels(cv::Mat& picture, std::span<const TerrainClass> labels) {
  std::size_t i = 0;
  for (int row = 0; row < picture.rows; ++row) {
    for (int column = 0; column < picture.cols; ++column) {
      const TerrainClass label = labels[i++];
      if (label == TerrainClass::unknown) continue;
      auto& pixel = picture.at<cv::Vec3b>(row, column);
      const cv::Vec3b tint = color_of(label).pixel();
      for (int k = 0; k < 3; ++k)
        pixel[k] = cv::saturate_cast<std::uint8_t>((1 - kTint) * pixel[k] + kTint * tint[k]);
    }
  }
}

void draw_horizon(cv::Mat& picture, std::span<const float> row_px) {
  for (std::size_t x = 1; x < row_px.size(); ++x) {
    cv::line(picture, sub_pixel(static_cast<double>(x) - 1.0, row_px[x - 1]),
             sub_pixel(static_cast<double>(x), row_px[x]), kPaper.bgr(), 1, cv::LINE_AA, kSubPixelBits);
  }
}

void draw_flow(cv::Mat& picture, std::span<const FlowVector> vectors) {
  for (const FlowVector& v : vectors) {
    const cv::Point now = sub_pixel(v.x_px, v.y_px);
    cv::line(picture, sub_pixel(v.x_px + v.dx_px, v.y_px + v.dy_px), now, kAccent.bgr(), 1, cv::LINE_AA,
             kSubPixelBits);
    cv::circle(picture, now, 2 << kSubPixelBits, kAccent.bgr(), cv::FILLED, cv::LINE_AA, kSubPixelBits);
  }
}

void draw_contacts(cv::Mat& picture, const BottomFinder& finder) {
  const double strip_px = finder.strip_px();
  for (std::size_t strip = 0; strip < finder.contact_row_px().size(); ++strip) {
    const double row = finder.contact_row_px()[strip];
    if (row < 0.0) continue;
    const double left = strip_px * static_cast<double>(strip);
    const cv::Point from = sub_pixel(left, row), to = sub_pixel(left + strip_px - 1.0, row);
    cv::line(picture, from, to, kInk.bgr(), 4, cv::LINE_AA, kSubPixelBits);
    cv::line(picture, from, to, kStale.bgr(), 2, cv::LINE_AA, kSubPixelBits);
  }
}

}  // namespace

cv::Mat view_of(std::span<const std::uint8_t> bgr, int width_px, int height_px) {
  // OpenCV has no read-only view.
  return {height_px, width_px, CV_8UC3, const_cast<std::uint8_t*>(bgr.data())};
}

cv::Rect pixel_rect(const ImageRect& rect, double scale) {
  const auto at = [scale](float value) { return static_cast<int>(std::lround(scale * value)); };
  return {at(rect.x_px), at(rect.y_px), std::max(1, at(rect.width_px)), std::max(1, at(rect.height_px))};
}

std::vector<ImageRect> touched_patches(std::span<const Lesson> lessons) {
  std::vector<ImageRect> patches;
  for (const Lesson& lesson : lessons) {
    if (lesson.event.in_view && lesson.event.frames_back == 0) patches.push_back(lesson.event.patch_px);
  }
  return patches;
}

cv::Mat draw_frame(const Frame& frame, const Robot& robot, std::span<const ImageRect> touched) {
  const Sight& sight = robot.sight();
  cv::Mat picture = view_of(frame.bgr, frame.width_px, frame.height_px).clone();
  tint_labels(picture, sight.labels());
  draw_horizon(picture, sight.ground().horizon_row_px());
  draw_flow(picture, sight.vectors());
  draw_contacts(picture, sight.bottom_finder());
  if (const RoadFollower* road = sight.road()) draw_road(picture, *road);
  for (const ImageRect& patch : touched) cv::rectangle(picture, pixel_rect(patch, 1.0), kPaper.bgr(), 2);
  if (robot.motion() != nullptr) {
    draw_tracks(picture, robot.motion()->report().tracks, robot.motion()->report().features);
  }
  return picture;
}

}  // namespace hindsight::tools
