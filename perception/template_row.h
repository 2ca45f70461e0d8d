// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Matching of a strip along one row of a picture (thesis 4.1, equation 4.1).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "perception/color_view.h"

namespace hindsight {

enum class TemplateMatch : std::uint8_t {
  squared_difference = 0,  ///< (4.1): 0 where the strip is the same, as TM_SQDIFF_NORMED of OpenCV
  correlation =
      1  ///< 1 - zero-mean normalised correlation over all channels, in [0, 2]: light does not matter
};

/// How well a strip of an earlier picture fits at each place of one row of the newest. No allocation after
/// construction. Not thread-safe. The sums are whole numbers: the same bits on every machine.
class TemplateRow {
 public:
  /// FatalError(kExitConfiguration) for a strip so large that its sums would not fit into 32 bits.
  TemplateRow(int picture_width_px, int max_width_px, int max_height_px);

  /// Takes the strip with its top left corner at (left, top) out of a picture, in which it must lie.
  void take(const ColorView& picture, int left_px, int top_px, int width_px, int height_px);

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }

  /// One value for each place of the strip's left edge from 0 on, picture width - strip width + 1 of them;
  /// smaller is better. `top_px`: of the strip; it must lie in the picture. A place without any texture where
  /// that is needed has 1.
  std::span<const float> search(const ColorView& picture, int top_px, TemplateMatch match);

 private:
  void spread_rows(const ColorView& picture, int top_px);
  void sum_energy(const ColorView& picture, int top_px);
  void score(TemplateMatch match, int places);

  int picture_width_px_;
  int max_height_px_;
  std::size_t plane_stride_;
  int width_px_ = 0;
  int height_px_ = 0;
  std::int64_t template_sum_ = 0;
  std::int64_t template_energy_ = 0;
  std::vector<std::uint32_t> template_quads_;  ///< four neighbours in x, one plane a channel and row
  std::vector<std::uint32_t> picture_quads_;   ///< the same of the searched rows, one from each pixel on
  std::vector<std::uint32_t> products_;        ///< sum of T I
  std::vector<std::int64_t> column_sums_, column_energies_;
  std::vector<std::int64_t> sums_, energies_;  ///< of I under the strip
  std::vector<float> response_;
};

}  // namespace hindsight
