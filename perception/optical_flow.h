// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Reverse optical flow at the corners of the newest frame (thesis 2.1 and 2.2).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "perception/corner_detector.h"
#include "perception/flow_vector.h"
#include "perception/image_pyramid.h"
#include "perception/lucas_kanade.h"
#include "perception/optical_flow_params.h"

namespace hindsight {

/// Finds corners in each new frame t and tracks them into frame t-1. Pure: what it returns depends on the
/// frames alone, bit for bit, on every machine. No allocation after construction. Not thread-safe.
class OpticalFlow {
 public:
  OpticalFlow(const OpticalFlowParams& params, int width_px, int height_px);

  /// Takes the next frame: 8-bit BGR, width * height * 3 bytes, rows without padding. Returns the flow of
  /// every corner that was found again in the frame before, valid until the next call; empty for the first
  /// frame, and for one without texture.
  std::span<const FlowVector> update(std::span<const std::uint8_t> bgr);

  /// Forgets the last frame: the stream of images was interrupted.
  void reset() { has_last_ = false; }

  /// The corners of the newest frame, tracked or not, strongest first.
  std::span<const Point2f> features() const { return features_; }
  /// Of the newest frame.
  const ImagePyramid& pyramid() const { return current_; }

 private:
  void sort_features();
  std::size_t band_of(Point2f p) const;
  void track_into_last();
  void track_forth();
  bool came_back(std::size_t i) const;

  OpticalFlowParams params_;
  CornerDetector detector_;
  ImagePyramid current_;
  ImagePyramid last_;
  bool has_last_ = false;
  std::span<const Point2f> features_;
  std::array<std::size_t, 16> band_ends_{};
  std::vector<Point2f> sorted_px_;     ///< the features, band by band
  std::vector<TrackedPoint> tracked_;  ///< of the way back, then of the way forth
  std::vector<Point2f> corners_px_;    ///< the features that were found in the last frame
  std::vector<Point2f> matches_px_;    ///< and their places there
  std::vector<FlowVector> flow_;
};

}  // namespace hindsight
