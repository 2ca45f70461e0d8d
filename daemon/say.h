// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace hindsight {

/// syslog's severities, as journald reads them from a line's "<N>".
enum class Severity { error = 3, warning = 4, notice = 5, info = 6 };

/// One line to stderr, with its severity in front where journald listens. Any thread, but never the loop or the reflex
/// in steady state: it may block.
void say_line(Severity severity, std::string_view text);

template <typename... Args>
void say(Severity severity, fmt::format_string<Args...> format, Args&&... args) {
  say_line(severity, fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace hindsight
