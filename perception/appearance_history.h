// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// How the world looked: the last frames' pictures, for training on what was seen then (thesis 5.1).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "config/params.h"
#include "perception/camera_model.h"

namespace hindsight {

using Bgr = std::array<std::uint8_t, 3>;

struct AppearanceHistoryParams {
  // 2: a quarter of the memory (52 MB for 200 frames of 720 x 480); training takes colours of patches, not
  // edges.
  int shrink = 2;

  void visit(auto&& param) {
    param("shrink", shrink, Range{1, 4},
          "pictures are kept 1/shrink as wide and high, box average: 1 (the thesis), 2 or 4");
  }
};

/// Ring of pictures, all memory reserved at construction. frames_back counts from the newest, which is 0, as
/// in the flow history. One thread.
class AppearanceHistory {
 public:
  /// depth: pictures held. Throws FatalError(78) for a shrink that is not 1, 2 or 4.
  AppearanceHistory(const AppearanceHistoryParams& params, int depth, int width_px, int height_px);

  /// bgr: row-major, 3 bytes a pixel, width x height as given above.
  void push(std::span<const std::uint8_t> bgr);

  /// Forgets all pictures: the stream of frames was interrupted.
  void clear() { size_ = 0; }

  int size() const { return size_; }  ///< pictures held now
  int depth() const { return depth_; }
  int shrink() const { return shrink_; }
  int stored_width_px() const { return stored_width_px_; }
  int stored_height_px() const { return stored_height_px_; }

  /// Index of the stored pixel that shows a point of the full picture, or -1 outside of it.
  int stored_index(ImagePoint full_px) const;
  /// The stored pixel; frames_back < size(), index from stored_index().
  Bgr stored(int frames_back, int index) const;
  /// The whole stored picture, row-major BGR; empty where frames_back is not in [0, size()).
  std::span<const std::uint8_t> picture(int frames_back) const;
  /// Appends the stored pixels of a region of the full picture, clipped to it, each once.
  void collect(int frames_back, const ImageRect& full_px, std::vector<Bgr>& pixels) const;

 private:
  std::size_t slot_offset(int frames_back) const;

  int depth_;
  int shrink_;
  int width_px_;
  int height_px_;
  int stored_width_px_;
  int stored_height_px_;
  int newest_ = 0;  ///< slot
  int size_ = 0;
  std::size_t picture_bytes_;
  std::vector<std::uint8_t> ring_;
  std::vector<std::uint16_t> row_sums_;  ///< of `shrink` rows, byte by byte
  std::vector<std::uint8_t> averages_;   ///< of `shrink` pixels from each on
};

}  // namespace hindsight
