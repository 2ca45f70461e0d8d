// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "daemon/replay_run.h"
#include "tools/report_folder.h"
#include "tools/report_gallery.h"
#include "tools/report_trace.h"

namespace hindsight::tools {

/// Writes the map, the spectrograms and index.html, which shows all of a report; `run` has ended. `video`: file in the
/// folder, or empty. FatalError 74.
void write_page(const ReportFolder& folder, const std::string& log, ReplayRun& run, const RunTrace& trace,
                const Gallery& gallery, const std::string& video);

}  // namespace hindsight::tools
