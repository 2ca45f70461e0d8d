// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/spy_command.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>

#include "config/exit_code.h"

namespace hindsight::tools {
namespace {

int become_spy(std::string url) {
  std::string program = std::filesystem::read_symlink("/proc/self/exe").replace_filename("hindsight-spy");
  char* arguments[] = {program.data(), url.empty() ? nullptr : url.data(), nullptr};
  execv(program.c_str(), arguments);
  throw FatalError(kExitNoInput, program + ": " + std::strerror(errno));
}

}  // namespace

void add_spy(CLI::App& app, Run& run) {
  CLI::App* command =
      app.add_subcommand("spy", "show what hindsightd publishes, decoded, in lcm-spy's windows");
  auto url = std::make_shared<std::string>();
  command->add_option("url", *url, "LCM URL; default: LCM_DEFAULT_URL, else LCM's own");
  command->callback([url, &run] { run = [url] { return become_spy(*url); }; });
}

}  // namespace hindsight::tools
