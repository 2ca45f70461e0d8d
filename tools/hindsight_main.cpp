// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <CLI/CLI.hpp>
#include <cstdio>

#include "config/exit_code.h"
#include "perception/single_thread.h"
#include "tools/bench_command.h"
#include "tools/commands.h"
#include "tools/eval_command.h"
#include "tools/experiment_command.h"
#include "tools/import_command.h"
#include "tools/render_command.h"
#include "tools/report_command.h"
#include "tools/send_command.h"
#include "tools/sim_command.h"
#include "tools/spy_command.h"
#include "tools/verify_command.h"

int main(int argc, char** argv) {
  using namespace hindsight;
  keep_opencv_single_threaded();
  CLI::App app{"hindsight: the tool beside the daemon hindsightd"};
  app.require_subcommand(1);
  tools::Run run = [] { return static_cast<int>(kExitOk); };
  tools::add_bench(app, run);
  tools::add_eval(app, run);
  tools::add_experiment(app, run);
  tools::add_import(app, run);
  tools::add_render(app, run);
  tools::add_report(app, run);
  tools::add_send(app, run);
  tools::add_sim(app, run);
  tools::add_spy(app, run);
  tools::add_verify(app, run);
  try {
    app.parse(argc, argv);
    return run();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitUsage;
  } catch (const FatalError& error) {
    std::fprintf(stderr, "hindsight: %s\n", error.what());
    return error.code();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hindsight: internal error: %s\n", error.what());
    return kExitSoftware;
  }
}
