// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "perception/evidence_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/exit_code.h"

namespace hindsight {
namespace {

int modulo(int value, int n) {
  const int rest = value % n;
  return rest < 0 ? rest + n : rest;
}

void scale(std::array<float, kLabelCount>& votes, float factor) {
  for (float& v : votes) v *= factor;
}

float sum(const std::array<float, kLabelCount>& votes) { return votes[0] + votes[1] + votes[2]; }

Cell south_west_of(Cell centre, int size_cells) {
  return {centre.i - size_cells / 2, centre.j - size_cells / 2};
}

void require(bool holds, const char* what, double value, double limit) {
  if (!holds)
    throw FatalError(kExitConfiguration,
                     fmt::format("evidence grid: {}, but they are {} and {}", what, value, limit));
}

void check(const EvidenceGridParams& p) {
  const double half_m = 0.5 * p.size_cells * p.resolution_m;
  require(p.margin_m < half_m, "margin_m must be below half the window's side in metres", p.margin_m, half_m);
  require(p.min_evidence < p.max_evidence, "min_evidence must be below max_evidence", p.min_evidence,
          p.max_evidence);
  require(p.max_frame_weight <= p.max_evidence, "max_frame_weight must not be above max_evidence",
          p.max_frame_weight, p.max_evidence);
  require(p.leave_share <= p.enter_share, "leave_share must not be above enter_share", p.leave_share,
          p.enter_share);
}

}  // namespace

EvidenceGrid::EvidenceGrid(const EvidenceGridParams& params) : params_(params) {
  check(params);
  const auto cells =
      static_cast<std::size_t>(params.size_cells) * static_cast<std::size_t>(params.size_cells);
  slots_.resize(cells);
  costs_.resize(cells, CellCost::none);
  touched_.reserve(cells);
  changes_.reserve(cells);
  window_ = {south_west_of({0, 0}, params.size_cells), params.size_cells, params.resolution_m};
  torus_i_ = modulo(window_.origin.i, params.size_cells);
  torus_j_ = modulo(window_.origin.j, params.size_cells);
}

std::size_t EvidenceGrid::slot_at(int column, int row) const {
  const int n = window_.size_cells;
  int i = torus_i_ + column, j = torus_j_ + row;
  if (i >= n) i -= n;
  if (j >= n) j -= n;
  return static_cast<std::size_t>(j) * static_cast<std::size_t>(n) + static_cast<std::size_t>(i);
}

Cell EvidenceGrid::cell_of(std::size_t slot) const {
  const int n = window_.size_cells;
  int column = static_cast<int>(slot) % n - torus_i_, row = static_cast<int>(slot) / n - torus_j_;
  if (column < 0) column += n;
  if (row < 0) row += n;
  return {window_.origin.i + column, window_.origin.j + row};
}

bool EvidenceGrid::recentre(const Pose2& X_WB) {
  const Cell robot = window_.cell_at(X_WB.x_m, X_WB.y_m);
  const int margin = static_cast<int>(std::ceil(params_.margin_m / window_.resolution_m));
  const int column = robot.i - window_.origin.i, row = robot.j - window_.origin.j;
  const int last = window_.size_cells - 1 - margin;
  if (column >= margin && row >= margin && column <= last && row <= last) return false;
  const Cell origin = south_west_of(robot, window_.size_cells);
  if (origin == window_.origin) return false;
  settle();
  clear_changes();
  move_to(origin);
  return true;
}

void EvidenceGrid::move_to(Cell origin) {
  const GridWindow before = window_;
  window_.origin = origin;
  torus_i_ = modulo(origin.i, window_.size_cells);
  torus_j_ = modulo(origin.j, window_.size_cells);
  for (int row = 0; row < window_.size_cells; ++row) {
    for (int column = 0; column < window_.size_cells; ++column) {
      if (before.contains({origin.i + column, origin.j + row})) continue;
      const std::size_t slot = slot_at(column, row);
      slots_[slot] = Slot{};
      costs_[slot] = CellCost::none;
    }
  }
}

void EvidenceGrid::vote(Cell cell, TerrainClass label, float weight) {
  if (window_.contains(cell) && label != TerrainClass::unknown) add_to_frame(slot_of(cell), label, weight);
}

void EvidenceGrid::vote(std::span<const GroundVote> votes, const Pose2& X_WB) {
  // From B to cells, counted from the window's corner, where single precision is good to a thousandth of a
  // cell.
  const double per_m = 1.0 / window_.resolution_m;
  const auto c = static_cast<float>(std::cos(X_WB.heading_rad) * per_m),
             s = static_cast<float>(std::sin(X_WB.heading_rad) * per_m);
  const auto x0 = static_cast<float>(X_WB.x_m * per_m - window_.origin.i),
             y0 = static_cast<float>(X_WB.y_m * per_m - window_.origin.j);
  const auto n = static_cast<float>(window_.size_cells);
  for (const GroundVote& v : votes) {
    const float x = x0 + c * v.x_B_m - s * v.y_B_m, y = y0 + s * v.x_B_m + c * v.y_B_m;
    if (!(x >= 0.0F && y >= 0.0F && x < n && y < n)) continue;
    add_to_frame(slot_at(static_cast<int>(x), static_cast<int>(y)), v.label, v.weight);
  }
}

inline void EvidenceGrid::add_to_frame(std::size_t slot, TerrainClass label, float weight) {
  Slot& s = slots_[slot];
  if (!s.touched) {
    s.touched = true;
    touched_.push_back(static_cast<std::uint32_t>(slot));
  }
  s.frame[static_cast<std::size_t>(label)] += weight;
}

void EvidenceGrid::settle() {
  for (const std::uint32_t slot : touched_) settle_slot(slot);
  touched_.clear();
}

void EvidenceGrid::settle_slot(std::size_t slot) {
  Slot& s = slots_[slot];
  const auto limit = static_cast<float>(params_.max_frame_weight);
  const float total = sum(s.frame);
  if (total > limit) scale(s.frame, limit / total);
  s.mark_strength -= s.frame[0];
  add_votes(s, s.frame);
  s.frame = {};
  s.touched = false;
  update_cost(slot);
}

/// Older votes make room for new ones.
void EvidenceGrid::add_votes(Slot& slot, const std::array<float, kLabelCount>& votes) const {
  const float room = std::max(0.0F, static_cast<float>(params_.max_evidence) - sum(votes));
  const float before = sum(slot.votes);
  if (before > room) scale(slot.votes, room / before);
  for (std::size_t k = 0; k < votes.size(); ++k) slot.votes[k] += votes[k];
}

void EvidenceGrid::mark(Cell cell, CellCost cost, float strength) {
  if (!window_.contains(cell)) return;
  const std::size_t slot = slot_of(cell);
  Slot& s = slots_[slot];
  if (cost == CellCost::none) {
    s.mark_strength -= strength;
    add_votes(s, {std::min(strength, static_cast<float>(params_.max_evidence)), 0.0F, 0.0F});
  } else {
    s.mark = std::max(s.mark, cost);
    s.mark_strength = std::max(s.mark_strength, strength);
  }
  update_cost(slot);
}

CellCost EvidenceGrid::cost_from_votes(const Slot& slot, CellCost present) const {
  const float total = sum(slot.votes);
  if (total < static_cast<float>(params_.min_evidence)) return CellCost::none;
  const auto reached = [&](float votes, CellCost level) {
    return votes >= total * static_cast<float>(present >= level ? params_.leave_share : params_.enter_share);
  };
  if (slot.votes[2] > 0.0F && reached(slot.votes[2], CellCost::lethal)) return CellCost::lethal;
  const float obstacle = slot.votes[1] + slot.votes[2];
  return obstacle > 0.0F && reached(obstacle, CellCost::high) ? CellCost::high : CellCost::none;
}

void EvidenceGrid::update_cost(std::size_t slot) {
  Slot& s = slots_[slot];
  if (!(s.mark_strength > 0.0F)) s.mark = CellCost::none, s.mark_strength = 0.0F;
  const CellCost cost = std::max(s.mark, cost_from_votes(s, costs_[slot]));
  if (cost == costs_[slot]) return;
  costs_[slot] = cost;
  if (s.change == kUnchanged) {
    s.change = static_cast<std::int32_t>(changes_.size());
    changes_.push_back({cell_of(slot), cost});
  } else {
    changes_[static_cast<std::size_t>(s.change)].cost = cost;
  }
}

CellCost EvidenceGrid::cost(Cell cell) const {
  return window_.contains(cell) ? costs_[slot_of(cell)] : CellCost::none;
}

CellEvidence EvidenceGrid::evidence(Cell cell) const {
  if (!window_.contains(cell)) return {};
  const Slot& s = slots_[slot_of(cell)];
  return {s.votes, s.mark, s.mark_strength};
}

void EvidenceGrid::clear_changes() {
  for (const CellChange& change : changes_) slots_[slot_of(change.cell)].change = kUnchanged;
  changes_.clear();
}

void EvidenceGrid::copy_costs(std::span<CellCost> row_major_of_window) const {
  const auto n = static_cast<std::size_t>(window_.size_cells);
  const auto wrap = static_cast<std::ptrdiff_t>(window_.size_cells - torus_i_);
  for (std::size_t row = 0; row < n; ++row) {
    const auto from = costs_.begin() + static_cast<std::ptrdiff_t>(slot_at(0, static_cast<int>(row)) -
                                                                   static_cast<std::size_t>(torus_i_));
    const auto to = row_major_of_window.begin() + static_cast<std::ptrdiff_t>(row * n);
    std::copy(from + torus_i_, from + static_cast<std::ptrdiff_t>(n), to);
    std::copy(from, from + torus_i_, to + wrap);
  }
}

}  // namespace hindsight
