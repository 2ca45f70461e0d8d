// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/say.h"

#include <cstdio>
#include <cstdlib>

namespace hindsight {

void say_line(Severity severity, std::string_view text) {
  static const bool journal = std::getenv("JOURNAL_STREAM") != nullptr;
  const std::string line = journal ? fmt::format("<{}>{}\n", static_cast<int>(severity), text)
                                   : fmt::format("hindsightd: {}\n", text);
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace hindsight
