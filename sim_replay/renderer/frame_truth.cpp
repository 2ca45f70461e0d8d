// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/renderer/frame_truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim_replay/renderer/scene.h"

namespace hindsight {
namespace {

TruthLabel label_of(const World& world, std::uint16_t object) {
  if (object == 0) return TruthLabel::sky;
  if (object == kGroundObject) return TruthLabel::ground;
  if (object == kTrailObject) return TruthLabel::road;
  std::size_t index = object;
  if (index <= world.trees.size()) return TruthLabel::tree;
  index -= world.trees.size();
  if (index <= world.bushes.size()) return TruthLabel::bush;
  index -= world.bushes.size();
  return index <= world.rocks.size() ? TruthLabel::rock : TruthLabel::fence;
}

/// Ground is one surface, trail or not.
std::uint16_t surface_of(std::uint16_t object) { return object == kTrailObject ? kGroundObject : object; }

/// Reciprocal depth is linear over a plane, so that interpolating it is exact there.
float inverse_depth(const Lens& lens, const WideTruth& wide, glm::vec2 px, std::size_t nearest) {
  const int x = std::clamp(static_cast<int>(px.x), 0, lens.wide.width_px - 2);
  const int y = std::clamp(static_cast<int>(px.y), 0, lens.wide.height_px - 2);
  const float tx = px.x - static_cast<float>(x), ty = px.y - static_cast<float>(y);
  const auto at = [&](int u, int v) { return static_cast<std::size_t>(v * lens.wide.width_px + u); };
  const std::array<std::size_t, 4> corners = {at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)};
  const std::array<float, 4> shares = {(1.0F - tx) * (1.0F - ty), tx * (1.0F - ty), (1.0F - tx) * ty,
                                       tx * ty};
  float sum = 0.0F;
  for (std::size_t i = 0; i < 4; ++i) {
    if (surface_of(wide.objects[corners[i]]) != surface_of(wide.objects[nearest]))
      return wide.depths[nearest];
    sum += shares[i] * wide.depths[corners[i]];
  }
  return sum;
}

}  // namespace

void fill_truth(const World& world, const Lens& lens, const WideTruth& wide, RenderedFrame& frame) {
  const std::size_t count = lens.sources_px.size();
  frame.labels.resize(count);
  frame.objects.resize(count);
  frame.depth_m.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec2 px = lens.sources_px[i];
    const int x = std::clamp(static_cast<int>(px.x + 0.5F), 0, lens.wide.width_px - 1);
    const int y = std::clamp(static_cast<int>(px.y + 0.5F), 0, lens.wide.height_px - 1);
    const auto nearest = static_cast<std::size_t>(y * lens.wide.width_px + x);
    const std::uint16_t object = wide.objects[nearest];
    frame.labels[i] = label_of(world, object);
    frame.objects[i] = object >= kTrailObject ? std::uint16_t{0} : object;
    const float inverse = inverse_depth(lens, wide, px, nearest);
    frame.depth_m[i] = inverse > 0.0F ? kNear_m / inverse : std::numeric_limits<float>::infinity();
  }
}

}  // namespace hindsight
