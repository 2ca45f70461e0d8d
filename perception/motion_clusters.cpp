// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/motion_clusters.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace hindsight {
namespace {

constexpr int kMostSteps = 12;
constexpr float kStill_px = 0.1F;  ///< a step shorter than this is the last

}  // namespace

bool move_alike(Point2f a, Point2f b) {
  const float speed = 0.5F * (std::hypot(a.x_px, a.y_px) + std::hypot(b.x_px, b.y_px));
  return distance_px(a, b) < 0.4F + 0.35F * speed;
}

float link_reach_px(float half_kernel_px, Point2f v_px) {
  constexpr float kFrames = 4.0F;
  return std::max(half_kernel_px, kFrames * std::hypot(v_px.x_px, v_px.y_px));
}

MotionClusters::MotionClusters(double kernel_width_px, double kernel_height_px, std::size_t max_features)
    : half_width_px_(static_cast<float>(0.5 * kernel_width_px)),
      half_height_px_(static_cast<float>(0.5 * kernel_height_px)),
      reach_px_(std::max(half_width_px_, half_height_px_)) {
  order_.reserve(max_features), parent_.reserve(max_features), cluster_of_.reserve(max_features);
  starts_.reserve(max_features), clusters_.reserve(max_features), tiles_.reserve(max_features);
}

std::size_t MotionClusters::root(std::size_t i) {
  while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
  return i;
}

/// Features within half a kernel of one another that move alike are linked.
void MotionClusters::link(std::span<const MovingFeature> features) {
  parent_.resize(features.size());
  order_.resize(features.size());
  std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(features[a].at_px.x_px, a) < std::tuple(features[b].at_px.x_px, b);
  });
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const MovingFeature& a = features[order_[i]];
    const float reach_px = link_reach_px(reach_px_, a.v_px);
    for (std::size_t j = i + 1; j < order_.size(); ++j) {
      const MovingFeature& b = features[order_[j]];
      if (b.at_px.x_px - a.at_px.x_px > reach_px) break;
      if (distance_px(a.at_px, b.at_px) > reach_px || !move_alike(a.v_px, b.v_px)) continue;
      const std::size_t ra = root(order_[i]), rb = root(order_[j]);
      parent_[std::max(ra, rb)] = std::min(ra, rb);
    }
  }
}

/// One start for each tile and linked group: the mean of what the tile holds of it.
void MotionClusters::start_tiles(std::span<const MovingFeature> features) {
  tiles_.clear();
  for (std::size_t i = 0; i < features.size(); ++i) {
    tiles_.push_back({root(i), static_cast<int>(features[i].at_px.x_px / (2.0F * half_width_px_)),
                      static_cast<int>(features[i].at_px.y_px / (2.0F * half_height_px_)), i});
  }
  const auto key = [](const TileKey& t) { return std::tuple(t.group, t.column, t.row, t.feature); };
  std::sort(tiles_.begin(), tiles_.end(),
            [&](const TileKey& a, const TileKey& b) { return key(a) < key(b); });
}

MotionCluster MotionClusters::climb(MotionCluster peak, std::span<const MovingFeature> features) const {
  for (int step = 0; step < kMostSteps; ++step) {
    Point2f at{}, v{};
    float mass = 0.0F;
    for (const MovingFeature& f : features) {
      if (std::abs(f.at_px.x_px - peak.at_px.x_px) > half_width_px_ ||
          std::abs(f.at_px.y_px - peak.at_px.y_px) > half_height_px_ || !move_alike(f.v_px, peak.v_px)) {
        continue;
      }
      at.x_px += f.probability * f.at_px.x_px, at.y_px += f.probability * f.at_px.y_px;
      v.x_px += f.probability * f.v_px.x_px, v.y_px += f.probability * f.v_px.y_px;
      mass += f.probability;
    }
    if (mass <= 0.0F) break;
    const Point2f next{at.x_px / mass, at.y_px / mass};
    const float moved_px = distance_px(next, peak.at_px);
    peak.at_px = next, peak.v_px = {v.x_px / mass, v.y_px / mass}, peak.mass = mass;
    if (moved_px < kStill_px) break;
  }
  return peak;
}

std::span<const MotionCluster> MotionClusters::find(std::span<const MovingFeature> features) {
  clusters_.clear();
  cluster_of_.assign(features.size(), -1);
  link(features);
  start_tiles(features);
  for (std::size_t begin = 0; begin < tiles_.size();) {
    const std::size_t group = tiles_[begin].group;
    MotionCluster best, tile;
    float total = 0.0F;
    std::size_t i = begin;
    while (i < tiles_.size() && tiles_[i].group == group) {
      const int column = tiles_[i].column, row = tiles_[i].row;
      tile = {};
      for (; i < tiles_.size() && tiles_[i].group == group && tiles_[i].column == column &&
             tiles_[i].row == row;
           ++i) {
        const MovingFeature& f = features[tiles_[i].feature];
        tile.at_px.x_px += f.probability * f.at_px.x_px, tile.at_px.y_px += f.probability * f.at_px.y_px;
        tile.v_px.x_px += f.probability * f.v_px.x_px, tile.v_px.y_px += f.probability * f.v_px.y_px;
        tile.mass += f.probability;
        cluster_of_[tiles_[i].feature] = static_cast<int>(clusters_.size());
      }
      total += tile.mass;
      tile.at_px = {tile.at_px.x_px / tile.mass, tile.at_px.y_px / tile.mass};
      tile.v_px = {tile.v_px.x_px / tile.mass, tile.v_px.y_px / tile.mass};
      tile = climb(tile, features);
      if (tile.mass > best.mass) best = tile;
    }
    best.features = static_cast<int>(i - begin);
    best.mass = total;
    clusters_.push_back(best);
    begin = i;
  }
  return clusters_;
}

}  // namespace hindsight
