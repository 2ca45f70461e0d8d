// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// From colours' labels to the labels of what stands there.
//
// A pixel's colour alone says little: bark, litter and shade share colours. What says more is the texture
// around it, and what the pixels beside it say. Both are evidence in natural logarithms of a likelihood ratio
// (obstacle against good ground): so much for a colour called obstacle, as much against it for one called
// good, and the texture's own ratio; their mean over a window decides.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "config/params.h"
#include "perception/box_sum.h"
#include "perception/terrain_class.h"
#include "perception/texture_code.h"
#include "perception/texture_model.h"

namespace hindsight {

/// The defaults were chosen on training drives through nine simulated forests, none of them among those that
/// the documentation reports: mean obstacle coverage there is 87, 90 and 93 % with obstacle_log_odds of 0.6,
/// 0.8 and 1.0, and 13, 16 and 20 % of the ground is called obstacle. It is 1.0 because drives differ: with
/// 0.8 their coverage is 79 to 97 %, and three of them may lie below 89 %.
struct LabelParams {
  bool texture = true;
  int window_px = 10;
  double color_log_ratio = 1.5;
  double texture_limit = 2.0;
  double obstacle_log_odds = 1.0;

  void visit(auto&& param) {
    param("texture", texture, YesNo{}, "learn texture beside colour; thesis: false");
    param(
        "window_px", window_px, Range{0, 64},
        "side of the window whose pixels are judged together [px]; 0: every pixel alone, by its colour, the "
        "thesis");
    param("color_log_ratio", color_log_ratio, Range{0.0, 10.0}, "evidence of a colour's label [ln]");
    param("texture_limit", texture_limit, Range{0.0, 10.0}, "most evidence of a texture [ln]");
    param("obstacle_log_odds", obstacle_log_odds, Range{-10.0, 10.0},
          "what speaks for an obstacle beforehand, wherever there is evidence [ln]");
  }
};

/// Judges cells of cell_px x cell_px pixels, those of the appearance history's pictures. One thread.
class TerrainLabeller {
 public:
  /// Pixels behind the last whole cell of a row or column take its label.
  TerrainLabeller(const LabelParams& params, int width_px, int height_px, int cell_px);

  /// colors: one label a pixel, row-major; small_bgr: the same frame, 1 / cell_px as wide and high. One label
  /// a pixel, valid until the next call and as long as `colors`. An obstacle is lethal or bad as most
  /// obstacle colours in the window are, the more severe where equal. Unknown is a window without any known
  /// colour, or, as long as textures say nothing, with few. No allocation.
  std::span<const TerrainClass> label(std::span<const TerrainClass> colors,
                                      std::span<const std::uint8_t> small_bgr, const TextureModel& texture);

 private:
  void count_colors(std::span<const TerrainClass> colors);
  void weigh_textures(std::span<const std::uint8_t> small_bgr, const TextureModel& texture);
  double judged_cells(double known_px, int cells) const;
  void label_row(int row);
  TerrainClass judge(std::size_t cell, int cells) const;

  LabelParams params_;
  int width_px_;
  int height_px_;
  int cell_px_;
  int columns_;
  int rows_;
  TextureMap textures_;
  bool textures_speak_ = false;            ///< there is evidence of textures
  BoxSum<std::uint64_t> counts_;           ///< of colours' labels: good, bad, lethal, 21 bits each
  BoxSum<std::int32_t> texture_evidence_;  ///< [ln / kUnit]
  std::vector<TerrainClass> labels_;
};

}  // namespace hindsight
