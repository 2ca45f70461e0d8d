// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_lesson.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tools/report_frame.h"
#include "tools/report_style.h"

namespace hindsight::tools {
namespace {

constexpr int kSideWidthPx = 560;
constexpr int kCropHeightPx = 200;
constexpr int kGapPx = 8;
constexpr int kMarginPx = 4;  ///< of stored pixels around a magnified patch

cv::Mat enlarged(const cv::Mat& stored, int width_px, int height_px) {
  cv::Mat out;
  cv::resize(stored, out, {width_px, height_px}, 0, 0, cv::INTER_NEAREST);
  return out;
}

/// The patch with a margin, as large as fits, centred on a plain field.
cv::Mat magnified(const cv::Mat& stored, const cv::Rect& patch, Rgb color) {
  cv::Mat field(kCropHeightPx, kSideWidthPx, CV_8UC3, kUnknown.bgr());
  const cv::Rect wide(patch.x - kMarginPx, patch.y - kMarginPx, patch.width + 2 * kMarginPx,
                      patch.height + 2 * kMarginPx);
  const cv::Rect crop = wide & cv::Rect(0, 0, stored.cols, stored.rows);
  if (crop.empty()) return field;
  const double scale = std::min(static_cast<double>(kSideWidthPx) / crop.width,
                                static_cast<double>(kCropHeightPx) / crop.height);
  const cv::Size size(std::max(1, static_cast<int>(crop.width * scale)),
                      std::max(1, static_cast<int>(crop.height * scale)));
  const cv::Point corner((kSideWidthPx - size.width) / 2, (kCropHeightPx - size.height) / 2);
  enlarged(stored(crop), size.width, size.height).copyTo(field(cv::Rect(corner, size)));
  const cv::Point box_from(corner.x + static_cast<int>(std::lround((patch.x - crop.x) * scale)),
                           corner.y + static_cast<int>(std::lround((patch.y - crop.y) * scale)));
  cv::rectangle(field,
                cv::Rect(box_from, cv::Size(static_cast<int>(std::lround(patch.width * scale)),
                                            static_cast<int>(std::lround(patch.height * scale)))),
                color.bgr(), 2);
  return field;
}

cv::Mat side(const AppearanceHistory& appearance, int frames_back, const ImageRect& full_px, Rgb color) {
  const cv::Mat stored =
      view_of(appearance.picture(frames_back), appearance.stored_width_px(), appearance.stored_height_px());
  const int height_px = kSideWidthPx * stored.rows / stored.cols;
  cv::Mat frame = enlarged(stored, kSideWidthPx, height_px);
  const double shrink = 1.0 / appearance.shrink();
  cv::rectangle(frame, pixel_rect(full_px, shrink * kSideWidthPx / stored.cols), color.bgr(), 2);
  cv::Mat both(height_px + kGapPx + kCropHeightPx, kSideWidthPx, CV_8UC3, kPaper.bgr());
  frame.copyTo(both.rowRange(0, height_px));
  magnified(stored, pixel_rect(full_px, shrink), color).copyTo(both.rowRange(height_px + kGapPx, both.rows));
  return both;
}

}  // namespace

cv::Mat draw_lesson(const Lesson& lesson, const AppearanceHistory& appearance) {
  const int from = lesson.event.frames_back, to = lesson.traced.frames_back;
  if (!lesson.event.in_view || lesson.traced.points == 0) return {};
  if (appearance.picture(from).empty() || appearance.picture(to).empty()) return {};
  const Rgb color = color_of(lesson.event.label);
  const cv::Mat left = side(appearance, from, lesson.event.patch_px, color);
  const cv::Mat right = side(appearance, to, lesson.traced.there_px, color);
  cv::Mat pair(left.rows, 2 * kSideWidthPx + kGapPx, CV_8UC3, kPaper.bgr());
  left.copyTo(pair.colRange(0, kSideWidthPx));
  right.copyTo(pair.colRange(kSideWidthPx + kGapPx, pair.cols));
  return pair;
}

}  // namespace hindsight::tools
