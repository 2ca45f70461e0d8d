// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The data that the evidence grid hands to planning.
#pragma once

#include <cmath>
#include <cstdint>

namespace hindsight {

/// What a cell costs (thesis 5.1: none, high, lethal).
enum class CellCost : std::uint8_t { none = 0, high = 1, lethal = 2 };

/// A cell of the world grid: cell (i, j) covers [i, i+1) x [j, j+1) resolutions of W, east and north.
struct Cell {
  int i = 0;
  int j = 0;
  bool operator==(const Cell&) const = default;
};

/// A square window of size_cells x size_cells world cells whose south-west cell is `origin`.
struct GridWindow {
  Cell origin;
  int size_cells = 0;
  double resolution_m = 0.2;

  bool contains(Cell c) const {
    return c.i >= origin.i && c.j >= origin.j && c.i < origin.i + size_cells && c.j < origin.j + size_cells;
  }
  /// Row-major index (row = north) of a cell inside the window.
  int index(Cell c) const { return (c.j - origin.j) * size_cells + (c.i - origin.i); }
  Cell cell_at(double x_W_m, double y_W_m) const {
    return {static_cast<int>(std::floor(x_W_m / resolution_m)),
            static_cast<int>(std::floor(y_W_m / resolution_m))};
  }
  bool operator==(const GridWindow&) const = default;
};

/// One cell whose cost changed since the consumer last asked.
struct CellChange {
  Cell cell;
  CellCost cost = CellCost::none;
};

}  // namespace hindsight
