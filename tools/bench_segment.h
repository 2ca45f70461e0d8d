// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <opencv2/core.hpp>
#include <span>

namespace hindsight::tools {

/// Medians over the frames of one thread's processor time.
struct SegmentBench {
  double memcpy_ms = 0.0;           ///< copying a frame
  double segment_steady_ms = 0.0;   ///< Segmenter::segment while the mixture stands
  double segment_changed_ms = 0.0;  ///< the same in the frame right after a training event
  double em_predict_ms = 0.0;       ///< cv::ml::EM::predict on a sample, scaled to the frame
  int em_sample_px = 0;             ///< size of that sample
  double steady_over_memcpy() const { return segment_steady_ms / memcpy_ms; }
  double changed_over_memcpy() const { return segment_changed_ms / memcpy_ms; }
  double speedup_over_em() const { return em_predict_ms / segment_steady_ms; }
};

/// Frames: CV_8UC3, continuous, all of one size, at least one.
SegmentBench bench_segment(std::span<const cv::Mat> bgr_frames);

}  // namespace hindsight::tools
