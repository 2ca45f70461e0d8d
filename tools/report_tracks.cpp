// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/report_tracks.h"

#include <opencv2/imgproc.hpp>
#include <string>

#include "tools/png_chart.h"
#include "tools/report_style.h"

namespace hindsight::tools {
namespace {

constexpr float kArrowFrames = 10.0F;

cv::Point at(Point2f p) { return {cvRound(p.x_px), cvRound(p.y_px)}; }

}  // namespace

void draw_tracks(cv::Mat& picture, std::span<const Track> tracks, std::span<const MovingFeature> features) {
  for (const MovingFeature& f : features)
    cv::circle(picture, at(f.at_px), 1, kStale.bgr(), cv::FILLED, cv::LINE_AA);
  for (const Track& track : tracks) {
    const cv::Scalar color =
        track.unseen_frames > 0 ? kFaint.bgr() : color_of_line(static_cast<std::size_t>(track.id)).bgr();
    const cv::Point half = at(track.half_size_px), middle = at(track.at_px);
    cv::rectangle(picture, middle - half, middle + half, color, 1, cv::LINE_AA);
    cv::circle(picture, middle, 3, color, cv::FILLED, cv::LINE_AA);
    cv::arrowedLine(picture, middle,
                    at({track.at_px.x_px + kArrowFrames * track.v_px.x_px,
                        track.at_px.y_px + kArrowFrames * track.v_px.y_px}),
                    color, 1, cv::LINE_AA, 0, 0.25);
    const cv::Point text = middle + cv::Point(-half.x, -half.y - 3);
    cv::putText(picture, std::to_string(track.id), text, cv::FONT_HERSHEY_SIMPLEX, 0.45, kInk.bgr(), 3,
                cv::LINE_AA);
    cv::putText(picture, std::to_string(track.id), text, cv::FONT_HERSHEY_SIMPLEX, 0.45, color, 1,
                cv::LINE_AA);
  }
}

}  // namespace hindsight::tools
