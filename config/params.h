// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// How a parameter is declared: once, in a plain struct beside the algorithm that it belongs to.
//
//   struct TrackerParams {
//     int window_px = 9;
//     std::string fill = "neighbours";
//     void visit(auto&& param) {
//       param("window_px", window_px, Range{3, 31}, "side of the tracking window [px]");
//       param("fill", fill, Choices{"zero", "neighbours"}, "what an empty cell holds");
//     }
//   };
//
// The member's initial value is the default. The strict TOML reader, the printer and the checks all walk the
// same visit(); a parameter exists nowhere else. Supported types: bool, int, double, std::string, and
// std::vector<double>, std::vector<std::string>.
#pragma once

#include <initializer_list>
#include <limits>
#include <string_view>
#include <vector>

namespace hindsight {

/// Closed interval of allowed values. Every scalar number has one; for vectors it holds for each element.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};

/// The allowed values of a string parameter.
struct Choices {
  std::vector<std::string_view> values;
  Choices(std::initializer_list<std::string_view> list) : values(list) {}
};

/// A string or a list of strings without further restriction (a device name, a path).
struct AnyText {};

/// A yes-or-no parameter.
struct YesNo {};

}  // namespace hindsight
