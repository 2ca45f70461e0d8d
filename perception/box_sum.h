// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hindsight {

/// Sums over the square window around each element of a table, clipped at the table's border. The time does
/// not depend on the window's size. One thread; allocates at construction only.
template <typename Number>
class BoxSum {
 public:
  /// radius: the window reaches so far to each side.
  BoxSum(int columns, int rows, int radius)
      : columns_(columns),
        rows_(rows),
        radius_(radius),
        in_(size(columns, rows)),
        out_(size(columns, rows)),
        column_sums_(size(columns, 1)) {}

  int radius() const { return radius_; }
  /// What is summed, row-major, to be written by the caller.
  std::vector<Number>& in() { return in_; }
  /// The sums as of the last update().
  const std::vector<Number>& out() const { return out_; }

  void update() {
    std::ranges::fill(column_sums_, Number{});
    for (int row = 0; row < std::min(radius_, rows_); ++row) enter(row);
    for (int row = 0; row < rows_; ++row) {
      if (row + radius_ < rows_) enter(row + radius_);
      sum_along(row);
      if (row >= radius_) leave(row - radius_);
    }
  }

 private:
  static std::size_t size(int columns, int rows) {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
  const Number* row_of(int row) const { return in_.data() + size(columns_, row); }

  void enter(int row) {
    const Number* const from = row_of(row);
    for (std::size_t x = 0; x < column_sums_.size(); ++x) column_sums_[x] += from[x];
  }
  void leave(int row) {
    const Number* const from = row_of(row);
    for (std::size_t x = 0; x < column_sums_.size(); ++x) column_sums_[x] -= from[x];
  }
  void sum_along(int row) {
    Number* const to = out_.data() + size(columns_, row);
    const std::size_t count = column_sums_.size(), reach = static_cast<std::size_t>(radius_);
    Number sum{};
    for (std::size_t x = 0; x < std::min(reach, count); ++x) sum += column_sums_[x];
    for (std::size_t x = 0; x < count; ++x) {
      if (x + reach < count) sum += column_sums_[x + reach];
      to[x] = sum;
      if (x >= reach) sum -= column_sums_[x - reach];
    }
  }

  int columns_;
  int rows_;
  int radius_;
  std::vector<Number> in_, out_;
  std::vector<Number> column_sums_;  ///< over the rows of the window
};

}  // namespace hindsight
