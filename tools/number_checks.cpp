// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/number_checks.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace hindsight::tools {
namespace {

/// Nothing where the whole text is no finite number.
std::optional<double> number_in(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

CLI::Validator above_zero() {
  return {[](std::string& text) {
            const auto value = number_in(text);
            return value && *value > 0.0 ? std::string() : "must be a number above 0, not " + text;
          },
          "POSITIVE"};
}

CLI::Validator zero_or_above() {
  return {[](std::string& text) {
            const auto value = number_in(text);
            return value && *value >= 0.0 ? std::string() : "must be a number of 0 or more, not " + text;
          },
          "NONNEGATIVE"};
}

}  // namespace hindsight::tools
