// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/eval_command.h"

#include "tools/eval_planner_command.h"
#include "tools/eval_road_command.h"
#include "tools/eval_slip_command.h"
#include "tools/eval_traceback_command.h"
#include "tools/eval_tracks_command.h"

namespace hindsight::tools {

void add_eval(CLI::App& app, Run& run) {
  CLI::App& eval = *app.add_subcommand("eval", "measure a part of the system on recorded data");
  eval.require_subcommand(1);
  add_eval_planner(eval, run);
  add_eval_road(eval, run);
  add_eval_slip(eval, run);
  add_eval_traceback(eval, run);
  add_eval_tracks(eval, run);
}

}  // namespace hindsight::tools
