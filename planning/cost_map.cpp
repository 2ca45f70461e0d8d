// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "planning/cost_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace hindsight {

namespace {

constexpr std::size_t kMaxBodyCells = 32;

}  // namespace

CostMap::CostMap(const CostMapParams& params, const VehicleParams& vehicle, int window_cells,
                 double resolution_m)
    : params_(params),
      side_(window_cells),
      escape_cells_(static_cast<int>(std::lround(params.escape_radius_m / resolution_m))),
      ground_(static_cast<std::size_t>(window_cells) * static_cast<std::size_t>(window_cells),
              CellCost::none),
      counts_(ground_.size(), Counts{}),
      costs_(ground_.size(), kFreeCost),
      noted_(ground_.size(), 0) {
  const double core_m = vehicle.width_m / 2 + params.clearance_m;
  const double outer_m = core_m + params.margin_m, inner_m = core_m + params.margin_m / 2;
  const int reach = static_cast<int>(std::floor(outer_m / resolution_m));
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const double distance_m = std::hypot(dx, dy) * resolution_m;
      if (distance_m > outer_m) continue;
      const Reach ring = distance_m <= core_m ? core : distance_m <= inner_m ? margin_inner : margin_outer;
      lethal_kernel_.push_back({dx, dy, ring});
      if (ring == core) high_kernel_.push_back({dx, dy, high});
    }
  }
  touched_.reserve(ground_.size());
  changed_.reserve(ground_.size());
  body_cells_.reserve(kMaxBodyCells);
}

void CostMap::rebuild(std::span<const CellCost> window_costs, std::span<const int> body_cells) {
  assert(window_costs.size() == ground_.size());
  std::fill(ground_.begin(), ground_.end(), CellCost::none);
  std::fill(counts_.begin(), counts_.end(), Counts{});
  body_cells_.clear();
  for (int cell = 0; cell < side_ * side_; ++cell)
    set_ground(cell, window_costs[static_cast<std::size_t>(cell)]);
  move_escape(body_cells);
  for (const int cell : touched_) noted_[static_cast<std::size_t>(cell)] = 0;
  touched_.clear();
  for (int cell = 0; cell < side_ * side_; ++cell)
    costs_[static_cast<std::size_t>(cell)] = traversal_cost(cell);
}

std::span<const CostChange> CostMap::update(const GridWindow& window, std::span<const CellChange> changes,
                                            std::span<const int> body_cells) {
  for (const CellChange& change : changes)
    if (window.contains(change.cell)) set_ground(window.index(change.cell), change.cost);
  move_escape(body_cells);
  changed_.clear();
  for (const int cell : touched_) {
    const auto i = static_cast<std::size_t>(cell);
    noted_[i] = 0;
    const TraversalCost cost = traversal_cost(cell);
    if (cost == costs_[i]) continue;
    costs_[i] = cost;
    changed_.push_back({cell, cost});
  }
  touched_.clear();
  return changed_;
}

void CostMap::set_ground(int cell, CellCost cost) {
  CellCost& ground = ground_[static_cast<std::size_t>(cell)];
  if (ground == cost) return;
  if (ground == CellCost::lethal) add(cell, lethal_kernel_, -1);
  if (ground == CellCost::high) add(cell, high_kernel_, -1);
  ground = cost;
  if (ground == CellCost::lethal) add(cell, lethal_kernel_, 1);
  if (ground == CellCost::high) add(cell, high_kernel_, 1);
}

void CostMap::add(int cell, const std::vector<KernelCell>& kernel, int sign) {
  const int x = cell % side_, y = cell / side_;
  for (const KernelCell& k : kernel) {
    const int i = x + k.dx, j = y + k.dy;
    if (i < 0 || j < 0 || i >= side_ || j >= side_) continue;
    const int near = j * side_ + i;
    std::uint16_t& count = counts_[static_cast<std::size_t>(near)][k.reach];
    count = static_cast<std::uint16_t>(count + sign);
    note(near);
  }
}

void CostMap::note(int cell) {
  std::uint8_t& noted = noted_[static_cast<std::size_t>(cell)];
  if (noted != 0) return;
  noted = 1;
  touched_.push_back(cell);
}

void CostMap::move_escape(std::span<const int> body_cells) {
  note_escape();
  body_cells_.clear();
  const bool inside = std::any_of(body_cells.begin(), body_cells.end(),
                                  [this](int cell) { return grown_cost(cell) == kLethalCost; });
  if (!inside) return;
  body_cells_.insert(
      body_cells_.end(), body_cells.begin(),
      body_cells.begin() + static_cast<std::ptrdiff_t>(std::min(body_cells.size(), kMaxBodyCells)));
  note_escape();
}

void CostMap::note_escape() {
  for (const int body : body_cells_) {
    const int x = body % side_, y = body / side_;
    for (int j = std::max(0, y - escape_cells_); j <= std::min(side_ - 1, y + escape_cells_); ++j)
      for (int i = std::max(0, x - escape_cells_); i <= std::min(side_ - 1, x + escape_cells_); ++i)
        note(j * side_ + i);
  }
}

bool CostMap::may_escape(int cell) const {
  const int x = cell % side_, y = cell / side_;
  return std::any_of(body_cells_.begin(), body_cells_.end(), [&](int body) {
    const int dx = body % side_ - x, dy = body / side_ - y;
    return obstacle(cell) ? dx == 0 && dy == 0 : dx * dx + dy * dy <= escape_cells_ * escape_cells_;
  });
}

TraversalCost CostMap::grown_cost(int cell) const {
  const Counts& counts = counts_[static_cast<std::size_t>(cell)];
  if (counts[core] != 0) return kLethalCost;
  int cost = kFreeCost;
  if (counts[margin_outer] != 0) cost = std::max(cost, params_.margin_outer_cost);
  if (counts[margin_inner] != 0) cost = std::max(cost, params_.margin_inner_cost);
  if (counts[high] != 0) cost = std::max(cost, params_.high_cost);
  return static_cast<TraversalCost>(cost);
}

TraversalCost CostMap::traversal_cost(int cell) const {
  const TraversalCost cost = grown_cost(cell);
  return cost == kLethalCost && may_escape(cell) ? kHighestCost : cost;
}

}  // namespace hindsight
