// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The evidence grid's costs (thesis 5.1: none, high, lethal) as traversal costs of the vehicle's reference
// point: each obstacle grown by the vehicle's half width (C-space), with a soft margin around.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "config/vehicle_params.h"
#include "perception/evidence_grid_geometry.h"
#include "planning/grid_graph.h"

namespace hindsight {

struct CostMapParams {
  double clearance_m = 0.10;  ///< half a cell: where in its cell an obstacle stands is unknown
  double margin_m = 0.40;     ///< soft margin beyond, in two rings
  int margin_inner_cost = 8;
  int margin_outer_cost = 3;
  int high_cost = 12;
  double escape_radius_m = 0.80;  ///< around the robot, ground that is lethal by growth alone may be crossed

  void visit(auto&& param) {
    param("clearance_m", clearance_m, Range{0.0, 1.0}, "kept free beside the vehicle [m]");
    param("margin_m", margin_m, Range{0.0, 1.0}, "width of the soft margin around obstacles [m]");
    param("margin_inner_cost", margin_inner_cost, Range{1, 60},
          "cost of the margin's inner half (free ground: 1)");
    param("margin_outer_cost", margin_outer_cost, Range{1, 60},
          "cost of the margin's outer half (free ground: 1)");
    param("high_cost", high_cost, Range{1, 60}, "cost of high-cost ground (free ground: 1)");
    param("escape_radius_m", escape_radius_m, Range{0.0, 2.0},
          "where a robot inside a grown obstacle may move [m]");
  }
};

/// Not thread-safe; allocates at construction only.
class CostMap {
 public:
  CostMap(const CostMapParams& params, const VehicleParams& vehicle, int window_cells, double resolution_m);

  /// All costs anew from a whole window, row-major. `body_cells` as in update().
  void rebuild(std::span<const CellCost> window_costs, std::span<const int> body_cells);

  /// Takes the changed cells (those outside the window are ignored) and the window indices of the cells under
  /// the vehicle's discs (planning/body_discs.h). Where one of these is lethal the vehicle already stands
  /// inside a grown obstacle, as after a bump: ground nearby that is lethal by growth alone, and the cells it
  /// stands on, then cost kHighestCost, so that it can get out. Returns the traversal costs that became
  /// different, each cell at most once, valid until the next call.
  std::span<const CostChange> update(const GridWindow& window, std::span<const CellChange> changes,
                                     std::span<const int> body_cells);

  /// The present traversal costs, row-major.
  std::span<const TraversalCost> costs() const { return costs_; }
  TraversalCost cost(int cell) const { return costs_[static_cast<std::size_t>(cell)]; }
  /// Whether the ground itself, not only its neighbourhood, is lethal here.
  bool obstacle(int cell) const { return ground_[static_cast<std::size_t>(cell)] == CellCost::lethal; }

 private:
  /// How many cells of each kind reach a cell.
  enum Reach : std::uint8_t { core = 0, margin_inner = 1, margin_outer = 2, high = 3 };
  using Counts = std::array<std::uint16_t, 4>;
  struct KernelCell {
    int dx;
    int dy;
    Reach reach;
  };

  void set_ground(int cell, CellCost cost);
  void add(int cell, const std::vector<KernelCell>& kernel, int sign);
  void note(int cell);
  void move_escape(std::span<const int> body_cells);
  void note_escape();
  bool may_escape(int cell) const;
  TraversalCost grown_cost(int cell) const;
  TraversalCost traversal_cost(int cell) const;

  CostMapParams params_;
  int side_;
  int escape_cells_;
  std::vector<KernelCell> lethal_kernel_;
  std::vector<KernelCell> high_kernel_;
  std::vector<CellCost> ground_;
  std::vector<Counts> counts_;
  std::vector<TraversalCost> costs_;
  std::vector<std::uint8_t> noted_;
  std::vector<int> touched_;
  std::vector<CostChange> changed_;
  std::vector<int> body_cells_;  ///< while the vehicle stands inside a grown obstacle, else empty
};

}  // namespace hindsight
