// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include <sodium.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>

#include "config/exit_code.h"
#include "daemon/live_run.h"
#include "daemon/replay_run.h"
#include "daemon/run_setup.h"
#include "daemon/say.h"
#include "perception/single_thread.h"

namespace hindsight {
namespace {

std::atomic<bool> stop_requested{false};

struct Arguments {
  std::vector<std::string> configuration_files;
  ReplayJob replay;
  std::vector<std::string> faults;
  std::string record;
  bool check_config = false;
  bool print_config = false;
};

void declare(CLI::App& app, Arguments& arguments) {
  app.set_version_flag("--version", build_id());
  app.add_option("--config", arguments.configuration_files,
                 "Configuration file (TOML); may be given again, later files override earlier ones")
      ->type_name("FILE");
  app.add_option("--replay", arguments.replay.log, "Replay a run log in place of the hardware")->type_name("RUN.lcm");
  app.add_option("--pace", arguments.replay.pace,
                 "With --replay: times real time, with telemetry over LCM; without it as fast as it goes, without telemetry")
      ->check(CLI::Range(0.001, 1000.0))
      ->needs("--replay");
  app.add_flag("--recover", arguments.replay.recover, "With --replay: skip what is damaged in the log")
      ->needs("--replay");
  app.add_option("--inject", arguments.faults,
                 "With --replay: a fault to rehearse, such as camera:stuck:12.5s:2s: from 12.5 s on, for 2 s; may be "
                 "given again. Sources: camera, can, gpio, gps. Faults: off, stuck, garbage, wrong, slow, delayed, "
                 "intermittent")
      ->type_name("SOURCE:FAULT:BEGIN:LENGTH")
      ->needs("--replay");
  app.add_option("--record", arguments.record, "Write a run log")->type_name("OUT.lcm");
  app.add_flag("--check-config", arguments.check_config, "Read configuration, CAN protocol and calibration, and end");
  app.add_flag("--print-config", arguments.print_config, "Print the configuration in force, and end");
  app.footer("Exit codes: 0 ok, 64 usage, 65 damaged data, 66 no such input, 69 device absent or busy,\n"
             "70 internal error, 74 cannot write, 78 configuration.");
}

int check_config(const Arguments& arguments) {
  const Configuration configuration = load_configuration(arguments.configuration_files);
  const RobotSetup setup = make_setup(configuration, load_materials(configuration), "");
  setup.camera.require_size(configuration.camera.format.width_px, configuration.camera.format.height_px);
  const Robot robot(setup);
  std::puts("configuration ok");
  return kExitOk;
}

int run(Arguments arguments) {
  if (arguments.print_config) {
    std::fputs(to_text(load_configuration(arguments.configuration_files)).c_str(), stdout);
    return kExitOk;
  }
  if (arguments.replay.log.empty() && arguments.configuration_files.empty()) {
    throw FatalError(kExitUsage, "--config FILE is required (see --help)");
  }
  if (arguments.check_config) return check_config(arguments);
  if (arguments.replay.log.empty()) return run_live({arguments.configuration_files, arguments.record});
  arguments.replay.configuration_files = arguments.configuration_files;
  arguments.replay.record = arguments.record;
  for (const std::string& fault : arguments.faults) arguments.replay.faults.push_back(parse_fault(fault));
  for (int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { stop_requested = true; });
  return run_replay(arguments.replay, [] { return stop_requested.load(); });
}

}  // namespace
}  // namespace hindsight

int main(int argc, char** argv) {
  using namespace hindsight;
  keep_opencv_single_threaded();
  CLI::App app{"hindsightd: autonomy for an off-road vehicle that learns from what it touches"};
  Arguments arguments;
  declare(app, arguments);
  try {
    app.parse(argc, argv);
    if (sodium_init() < 0) throw FatalError(kExitSoftware, "libsodium does not start");
    return run(arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitUsage;
  } catch (const FatalError& error) {
    say(Severity::error, "{}", error.what());
    return error.code();
  } catch (const std::exception& error) {
    say(Severity::error, "internal error: {}", error.what());
    return kExitSoftware;
  }
}
