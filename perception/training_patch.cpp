// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/training_patch.h"

#include "perception/texture_code.h"

namespace hindsight {

TrainingPatchTracer::TrainingPatchTracer(const TrainingPatchParams& params) : params_(params) {
  stored_.reserve(static_cast<std::size_t>(params.max_points) * (params.looks == "all" ? kMostLooks : 1));
}

float TrainingPatchTracer::spacing_px(const ImageRect& patch_px) const {
  const auto points_at = [&](float step) {
    return std::ceil(patch_px.width_px / step) * std::ceil(patch_px.height_px / step);
  };
  float step = 1.0F;
  while (points_at(step) > static_cast<float>(params_.max_points)) step += 0.5F;
  return step;
}

/// False where nothing is stored of that place.
bool TrainingPatchTracer::end_at(const AppearanceHistory& appearance, float x_px, float y_px,
                                 int frames_back) {
  const int index = appearance.stored_index({x_px, y_px});
  if (index < 0 || frames_back >= appearance.size()) return false;
  stored_.push_back(static_cast<std::uint64_t>(frames_back) << 32U | static_cast<std::uint64_t>(index));
  return true;
}

void TrainingPatchTracer::take_pixels(const AppearanceHistory& appearance, PatchPixels& pixels) {
  std::sort(stored_.begin(), stored_.end());
  stored_.erase(std::unique(stored_.begin(), stored_.end()), stored_.end());
  const int width_px = appearance.stored_width_px();
  for (const std::uint64_t s : stored_) {
    const int frames_back = static_cast<int>(s >> 32U), index = static_cast<int>(s & 0xFFFFFFFFU);
    pixels.bgr.push_back(appearance.stored(frames_back, index));
    pixels.texture.push_back(texture_code_at(appearance.picture(frames_back), width_px,
                                             appearance.stored_height_px(), index % width_px,
                                             index / width_px));
  }
}

}  // namespace hindsight
