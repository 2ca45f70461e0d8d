// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace hindsight {

/// The name that takes the fewest insertions, deletions and replacements of characters to come from `name`;
/// the first of several. `known` must not be empty.
const std::string& nearest_name(std::string_view name, const std::set<std::string>& known);

}  // namespace hindsight
