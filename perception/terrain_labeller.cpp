// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/terrain_labeller.h"

#include <algorithm>
#include <cmath>

namespace hindsight {
namespace {

/// Of evidence in whole numbers: exact sums, the same on every machine.
constexpr double kUnit = 1024.0;
/// Three counts in one number, so that one sum does for all.
constexpr int kCountBits = 21;
constexpr std::uint64_t kCountOf[kLabelCount + 1] = {1, std::uint64_t{1} << kCountBits,
                                                     std::uint64_t{1} << 2 * kCountBits, 0};

/// Share of a window that must have evidence, or it is unknown.
constexpr double kLeastJudged = 0.3;

struct Counts {
  double good, bad, lethal;
};

Counts unpack(std::uint64_t packed) {
  constexpr std::uint64_t kMask = (std::uint64_t{1} << kCountBits) - 1;
  const auto count = [&](int i) { return static_cast<double>(packed >> i * kCountBits & kMask); };
  return {count(0), count(1), count(2)};
}

int radius_in_cells(int window_px, int cell_px) { return window_px / cell_px / 2; }

}  // namespace

TerrainLabeller::TerrainLabeller(const LabelParams& params, int width_px, int height_px, int cell_px)
    : params_(params),
      width_px_(width_px),
      height_px_(height_px),
      cell_px_(cell_px),
      columns_(width_px / cell_px),
      rows_(height_px / cell_px),
      textures_(columns_, rows_),
      counts_(columns_, rows_, radius_in_cells(params.window_px, cell_px)),
      texture_evidence_(columns_, rows_, counts_.radius()),
      labels_(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px),
              TerrainClass::unknown) {}

std::span<const TerrainClass> TerrainLabeller::label(std::span<const TerrainClass> colors,
                                                     std::span<const std::uint8_t> small_bgr,
                                                     const TextureModel& texture) {
  if (params_.window_px == 0) return colors;
  count_colors(colors);
  counts_.update();
  textures_speak_ = false;
  if (params_.texture) weigh_textures(small_bgr, texture);
  for (int row = 0; row < rows_; ++row) label_row(row);
  return labels_;
}

void TerrainLabeller::count_colors(std::span<const TerrainClass> colors) {
  const auto width = static_cast<std::size_t>(width_px_), side = static_cast<std::size_t>(cell_px_);
  std::uint64_t* counts = counts_.in().data();
  for (int row = 0; row < rows_; ++row, counts += columns_) {
    const TerrainClass* line = colors.data() + static_cast<std::size_t>(row) * side * width;
    std::fill_n(counts, columns_, std::uint64_t{0});
    for (std::size_t y = 0; y < side; ++y, line += width) {
      const TerrainClass* pixel = line;
      for (int column = 0; column < columns_; ++column) {
        for (std::size_t x = 0; x < side; ++x) counts[column] += kCountOf[static_cast<std::size_t>(*pixel++)];
      }
    }
  }
}

void TerrainLabeller::weigh_textures(std::span<const std::uint8_t> small_bgr, const TextureModel& texture) {
  std::array<std::int32_t, kTextureCodes> evidence;
  std::ranges::transform(texture.log_ratios(params_.texture_limit), evidence.begin(),
                         [](float ratio) { return static_cast<std::int32_t>(std::lround(kUnit * ratio)); });
  textures_speak_ = std::ranges::any_of(evidence, [](std::int32_t e) { return e != 0; });
  if (!textures_speak_) return;
  std::ranges::transform(textures_.update(small_bgr), texture_evidence_.in().begin(),
                         [&](std::uint8_t code) { return evidence[code]; });
  texture_evidence_.update();
}

/// The labels of a row of cells go to all its rows of pixels.
void TerrainLabeller::label_row(int row) {
  const int radius = counts_.radius();
  const auto reach = [radius](int at, int end) {
    return std::min(at + radius, end - 1) - std::max(at - radius, 0) + 1;
  };
  const int high = reach(row, rows_);
  const auto width = static_cast<std::size_t>(width_px_);
  TerrainClass* const line = &labels_[static_cast<std::size_t>(row * cell_px_) * width];
  const std::size_t first = static_cast<std::size_t>(row * columns_);
  for (int column = 0; column < columns_; ++column) {
    const TerrainClass label =
        judge(first + static_cast<std::size_t>(column), high * reach(column, columns_));
    const int begin_px = column * cell_px_, end_px = column + 1 < columns_ ? begin_px + cell_px_ : width_px_;
    std::fill(line + begin_px, line + end_px, label);
  }
  const int rows_px = row + 1 < rows_ ? cell_px_ : height_px_ - row * cell_px_;
  for (int y = 1; y < rows_px; ++y) std::copy_n(line, width, line + static_cast<std::size_t>(y) * width);
}

/// Every cell has a texture; those with known colours are fewer.
double TerrainLabeller::judged_cells(double known_px, int cells) const {
  return textures_speak_ ? cells : known_px / (cell_px_ * cell_px_);
}

TerrainClass TerrainLabeller::judge(std::size_t cell, int cells) const {
  const auto [good, bad, lethal] = unpack(counts_.out()[cell]);
  const double cell_area_px = cell_px_ * cell_px_;
  const double known_px = good + bad + lethal, judged = judged_cells(known_px, cells);
  if (known_px == 0.0 || judged < kLeastJudged * cells) return TerrainClass::unknown;
  const double of_colors = params_.color_log_ratio * (bad + lethal - good) / cell_area_px,
               of_textures = textures_speak_ ? texture_evidence_.out()[cell] / kUnit : 0.0;
  if (of_colors + of_textures < -params_.obstacle_log_odds * judged) return TerrainClass::good;
  return lethal >= bad ? TerrainClass::lethal : TerrainClass::bad;
}

}  // namespace hindsight
