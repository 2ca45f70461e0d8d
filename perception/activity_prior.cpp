// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/activity_prior.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

namespace hindsight {
namespace {

/// [frames of motion] What the map showed of a cell, or should have, counts as much as what is known without
/// it at so many.
constexpr double kDoubt = 4.0;
constexpr double kBeside = 0.5;  ///< what a neighbouring cell's motion counts for
constexpr std::array<float, 4> kSpeedWeights{1.0F, 0.6F, 0.2F, 0.05F};
constexpr std::array<float, 4> kDirectionWeights{1.0F, 0.7F, 0.3F, 0.1F};

Eigen::Vector2d mapped(const Eigen::Matrix3d& H, const Eigen::Vector2d& p) {
  return (H * p.homogeneous()).hnormalized();
}

double weight_beside(int columns, int rows) {
  return (columns == 0 ? 1.0 : kBeside) * (rows == 0 ? 1.0 : kBeside);
}

}  // namespace

Eigen::Matrix2d jacobian_of(const Eigen::Matrix3d& H, const Eigen::Vector2d& p) {
  const Eigen::Vector3d x = H * p.homogeneous();
  return (H.topLeftCorner<2, 2>() - x.head<2>() / x(2) * H.row(2).head<2>()) / x(2);
}

ActivityPrior::ActivityPrior(const ActivityMap& map)
    : map_(map), slot_(static_cast<std::size_t>(map.cells()) * static_cast<std::size_t>(map.cells()), -1) {
  double exposure = 0.0;
  for (const std::uint32_t frames : map_.exposures()) exposure += frames;
  if (exposure > 0.0) per_frame_ = static_cast<double>(map_.total()) / exposure;
  for (const ActivityMap::ActiveCell& cell : map_.active()) {
    for (int row = cell.row - 1; row <= cell.row + 1; ++row) {
      for (int column = cell.column - 1; column <= cell.column + 1; ++column) smooth(column, row);
    }
  }
}

void ActivityPrior::smooth(int column, int row) {
  constexpr int S = ActivityMap::kSpeeds, D = ActivityMap::kDirections;
  if (column < 0 || row < 0 || column >= map_.cells() || row >= map_.cells()) return;
  int& slot = slot_[static_cast<std::size_t>(row) * static_cast<std::size_t>(map_.cells()) +
                    static_cast<std::size_t>(column)];
  if (slot >= 0) return;
  slot = static_cast<int>(cells_.size());
  std::vector<float> bins(ActivityMap::kBins);
  double often = 0.0;
  for (int r = row - 1; r <= row + 1; ++r) {
    for (int c = column - 1; c <= column + 1; ++c) {
      const int active = map_.find(c, r);
      if (active < 0) continue;
      const auto a = static_cast<std::size_t>(active);
      const auto beside = static_cast<float>(weight_beside(c - column, r - row));
      often += beside * static_cast<float>(map_.active()[a].total);
      const auto counts = map_.counts(a);
      for (int s = 0; s < S; ++s) {
        for (int d = 0; d < D; ++d) {
          const std::uint32_t count = counts[static_cast<std::size_t>(s * D + d)];
          if (count == 0) continue;
          for (int i = std::max(0, s - 3); i <= std::min(S - 1, s + 3); ++i) {
            for (int j = -3; j <= 3; ++j) {
              bins[static_cast<std::size_t>(i * D + (d + j + D) % D)] +=
                  beside * static_cast<float>(count) *
                  kSpeedWeights[static_cast<std::size_t>(std::abs(i - s))] *
                  kDirectionWeights[static_cast<std::size_t>(std::abs(j))];
            }
          }
        }
      }
    }
  }
  float sum = 0.0F;
  for (const float b : bins) sum += b;
  float so_far = 0.0F;
  for (float& b : bins) b = so_far += b / sum;
  cells_.push_back({often, std::move(bins)});
}

void ActivityPrior::look(const Eigen::Matrix3d& H_G_image) { H_G_image_ = H_G_image; }

const ActivityPrior::Cell* ActivityPrior::cell_at(const Eigen::Vector2d& p_G) const {
  int column = 0, row = 0;
  map_.cell_of(p_G, column, row);
  if (column < 0 || row < 0 || column >= map_.cells() || row >= map_.cells()) return nullptr;
  const int slot = slot_[static_cast<std::size_t>(row) * static_cast<std::size_t>(map_.cells()) +
                         static_cast<std::size_t>(column)];
  return slot < 0 ? nullptr : &cells_[static_cast<std::size_t>(slot)];
}

double ActivityPrior::probability(Point2f at_px, Point2f v_px) const {
  const Eigen::Vector2d p(at_px.x_px, at_px.y_px), v(v_px.x_px, v_px.y_px);
  const Cell* cell = cell_at(mapped(H_G_image_, p));
  if (cell == nullptr) return 0.0;
  const std::size_t bin = activity_bin(map_, jacobian_of(H_G_image_, p) * v);
  return cell->cumulative[bin] - (bin == 0 ? 0.0F : cell->cumulative[bin - 1]);
}

bool ActivityPrior::sample(Point2f at_px, double uniform, Point2f& v_px) const {
  const Eigen::Vector2d p(at_px.x_px, at_px.y_px);
  const Cell* cell = cell_at(mapped(H_G_image_, p));
  if (cell == nullptr) return false;
  const auto at =
      std::upper_bound(cell->cumulative.begin(), cell->cumulative.end() - 1, static_cast<float>(uniform));
  const auto bin = static_cast<int>(at - cell->cumulative.begin());
  const double speed = (bin / ActivityMap::kDirections + 0.5) * map_.speed_per_bin();
  const double direction = ActivityMap::direction_of_bin(bin % ActivityMap::kDirections);
  const Eigen::Vector2d v = jacobian_of(H_G_image_, p).inverse() *
                            (speed * Eigen::Vector2d(std::cos(direction), std::sin(direction)));
  v_px = {static_cast<float>(v.x()), static_cast<float>(v.y())};
  return true;
}

/// Motion in cells as a Poisson process, its rate known beforehand as kDoubt frames of average motion of any
/// velocity would tell it (a gamma distribution): observed over expected, both with kDoubt added.
double ActivityPrior::log_ratio(Point2f at_px, Point2f v_px) const {
  const Eigen::Vector2d p_G = mapped(H_G_image_, {at_px.x_px, at_px.y_px});
  const Cell* cell = cell_at(p_G);
  const double observed =
      cell == nullptr ? 0.0
                      : cell->count * probability(at_px, v_px) * static_cast<double>(ActivityMap::kBins);
  return std::log((kDoubt + observed) / (kDoubt + expected_at(p_G)));
}

/// Motion that there would be here and beside if it were everywhere alike [frames].
double ActivityPrior::expected_at(const Eigen::Vector2d& p_G) const {
  int column = 0, row = 0;
  map_.cell_of(p_G, column, row);
  double exposure = 0.0;
  for (int r = row - 1; r <= row + 1; ++r) {
    for (int c = column - 1; c <= column + 1; ++c)
      exposure += weight_beside(c - column, r - row) * map_.exposure(c, r);
  }
  return per_frame_ * exposure;
}

}  // namespace hindsight
