// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace hindsight::tools {

/// Text for HTML and SVG, inside elements and quoted attributes: & < > " ' are replaced, and so are control
/// characters other than tab and line feed, which no browser shows.
std::string escape_html(std::string_view text);

}  // namespace hindsight::tools
