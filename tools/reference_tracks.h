// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <vector>

namespace hindsight::tools {

/// One place of the scene through consecutive frames, oldest first.
using ReferenceTrack = std::vector<cv::Point2f>;

/// Long tracks of dense, well-spread corners at full resolution, to hold tracebacks against: OpenCV's
/// pyramidal Lucas-Kanade with a window of 21 x 21 pixels, which at every step must find its way back to
/// within half a pixel.
class ReferenceTracks {
 public:
  /// Takes the next frame. Returns the tracks that ended in the frame before: lost, failed the check, or left
  /// the image.
  std::vector<ReferenceTrack> advance(const cv::Mat& bgr);

  /// The tracks that are alive in the newest frame.
  const std::vector<ReferenceTrack>& alive() const { return alive_; }

 private:
  std::vector<ReferenceTrack> extend(const cv::Mat& grey);
  void start_new(const cv::Mat& grey);

  cv::Mat last_grey_;
  std::vector<ReferenceTrack> alive_;
};

}  // namespace hindsight::tools
