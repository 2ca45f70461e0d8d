// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/activity_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hindsight {
namespace {

std::size_t bin_of(int speed, int direction) {
  return static_cast<std::size_t>(speed * ActivityMap::kDirections +
                                  (direction + ActivityMap::kDirections) % ActivityMap::kDirections);
}

}  // namespace

ActivityMap::ActivityMap(const ActivityMapParams& params)
    : params_(params),
      slot_(static_cast<std::size_t>(params.cells) * static_cast<std::size_t>(params.cells), -1),
      exposure_(slot_.size()) {
  active_.reserve(kMostActiveCells);
  counts_.resize(kMostActiveCells * kBins);
}

void ActivityMap::cell_of(const Eigen::Vector2d& p_G, int& column, int& row) const {
  const auto at = [this](double x) {
    return static_cast<int>(std::floor(std::clamp(x / params_.cell, -1e6, 1e6))) + params_.cells / 2;
  };
  column = at(p_G.x()), row = at(p_G.y());
}

Eigen::Vector2d ActivityMap::middle_of(int column, int row) const {
  const double half = params_.cells / 2;
  return {(column - half + 0.5) * params_.cell, (row - half + 0.5) * params_.cell};
}

int ActivityMap::find(int column, int row) const {
  return contains(column, row) ? slot_[index_of(column, row)] : -1;
}

std::size_t activity_bin(const ActivityMap& map, const Eigen::Vector2d& v_G) {
  const double speed = std::min<double>(v_G.norm() / map.speed_per_bin(), ActivityMap::kSpeeds - 1);
  double turn = std::atan2(v_G.y(), v_G.x()) / (2.0 * M_PI);
  turn -= std::floor(turn);
  const int direction = static_cast<int>(turn * ActivityMap::kDirections);
  return bin_of(static_cast<int>(speed), direction);
}

void ActivityMap::add(const Eigen::Vector2d& p_G, const Eigen::Vector2d& v_G) {
  if (!p_G.allFinite() || !v_G.allFinite()) return;
  int column = 0, row = 0;
  cell_of(p_G, column, row);
  if (!add_count(column, row, activity_bin(*this, v_G), 1)) ++lost_;
}

/// Row by row: the polygon's edges bound the columns that a row's middle line runs through.
void ActivityMap::look(std::span<const Eigen::Vector2d> view_G) {
  if (!std::all_of(view_G.begin(), view_G.end(), [](const Eigen::Vector2d& p) { return p.allFinite(); }))
    return;
  for (int row = 0; row < cells(); ++row) {
    const double y = middle_of(0, row).y();
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < view_G.size(); ++i) {
      const Eigen::Vector2d &a = view_G[i], &b = view_G[(i + 1) % view_G.size()];
      if ((a.y() <= y) == (b.y() <= y)) continue;
      const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      low = std::min(low, x), high = std::max(high, x);
    }
    for (int column = 0; column < cells(); ++column) {
      const double x = middle_of(column, row).x();
      if (x >= low && x < high) ++exposure_[index_of(column, row)];
    }
  }
}

bool ActivityMap::add_count(int column, int row, std::size_t bin, std::uint32_t count) {
  if (!contains(column, row) || bin >= kBins) return false;
  std::int16_t& slot = slot_[index_of(column, row)];
  if (slot < 0) {
    if (active_.size() == kMostActiveCells) return false;
    slot = static_cast<std::int16_t>(active_.size());
    active_.push_back({column, row, 0});
  }
  const auto s = static_cast<std::size_t>(slot);
  counts_[s * kBins + bin] += count;
  active_[s].total += count;
  total_ += count;
  return true;
}

void ActivityMap::merge(const ActivityMap& other, double angle_rad, const Eigen::Vector2d& t_G) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  for (std::size_t i = 0; i < other.active().size(); ++i) {
    const ActiveCell& cell = other.active()[i];
    const Eigen::Vector2d p = other.middle_of(cell.column, cell.row);
    int column = 0, row = 0;
    cell_of({c * p.x() - s * p.y() + t_G.x(), s * p.x() + c * p.y() + t_G.y()}, column, row);
    const auto counts = other.counts(i);
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      if (counts[bin] == 0) continue;
      const double speed = (static_cast<double>(bin / kDirections) + 0.5) * other.speed_per_bin();
      const double direction = direction_of_bin(static_cast<int>(bin % kDirections)) + angle_rad;
      const Eigen::Vector2d v = speed * Eigen::Vector2d(std::cos(direction), std::sin(direction));
      if (!add_count(column, row, activity_bin(*this, v), counts[bin])) lost_ += counts[bin];
    }
  }
  // The other way round, so that no cell is left out where cells of the two lie askew.
  for (int row = 0; row < cells(); ++row) {
    for (int column = 0; column < cells(); ++column) {
      const Eigen::Vector2d p = middle_of(column, row) - t_G;
      int column_O = 0, row_O = 0;
      other.cell_of({c * p.x() + s * p.y(), -s * p.x() + c * p.y()}, column_O, row_O);
      exposure_[index_of(column, row)] += other.exposure(column_O, row_O);
    }
  }
}

std::size_t find_modes(const ActivityMap& map, std::size_t active, std::span<ActivityMode> modes) {
  constexpr int S = ActivityMap::kSpeeds, D = ActivityMap::kDirections;
  const auto counts = map.counts(active);
  const double total = map.active()[active].total;
  std::array<double, ActivityMap::kBins> smooth{};
  const auto around = [&](int s, int d) {
    double sum = 0.0;
    for (int i = std::max(0, s - 1); i <= std::min(S - 1, s + 1); ++i) {
      for (int j = -2; j <= 2; ++j)
        sum += static_cast<double>((3 - std::abs(j)) * (2 - std::abs(i - s))) * counts[bin_of(i, d + j)];
    }
    return sum;
  };
  for (int s = 0; s < S; ++s) {
    for (int d = 0; d < D; ++d) smooth[bin_of(s, d)] = around(s, d);
  }
  std::size_t found = 0;
  for (int s = 0; s < S; ++s) {
    for (int d = 0; d < D; ++d) {
      const double here = smooth[bin_of(s, d)];
      bool peak = here > 0.0;
      for (int i = std::max(0, s - 2); i <= std::min(S - 1, s + 2) && peak; ++i) {
        for (int j = -3; j <= 3; ++j) {
          const double there = smooth[bin_of(i, d + j)];
          const bool before = i < s || (i == s && j < 0);
          if ((i != s || j != 0) && (there > here || (before && there == here))) peak = false;
        }
      }
      if (!peak) continue;
      double mass = 0.0;
      for (int i = std::max(0, s - 1); i <= std::min(S - 1, s + 1); ++i) {
        for (int j = -1; j <= 1; ++j) mass += counts[bin_of(i, d + j)];
      }
      ActivityMode mode{(s + 0.5) * map.speed_per_bin(), ActivityMap::direction_of_bin(d), mass / total};
      std::size_t at = found < modes.size() ? found++ : modes.size() - 1;
      if (at == modes.size() - 1 && found == modes.size() && modes[at].share >= mode.share &&
          modes[at].share > 0.0)
        continue;
      modes[at] = mode;
      for (; at > 0 && modes[at - 1].share < modes[at].share; --at) std::swap(modes[at - 1], modes[at]);
    }
  }
  return found;
}

}  // namespace hindsight
