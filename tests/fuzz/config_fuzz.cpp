// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A configuration file, read over the defaults as the daemon does. What is accepted must print to text that
// reads back to the same.
#include "config/configuration.h"
#include "daemon/robot_config.h"
#include "fuzz.h"

namespace hindsight::fuzz {
namespace {

void run(Bytes bytes) {
  or_fatal_error([&] {
    Configuration configuration;
    read_configuration(configuration, ConfigDocument::parse(text_of(bytes), "fuzz.toml"));
    const std::string printed = print_configuration(configuration);
    Configuration again;
    try {
      read_configuration(again, ConfigDocument::parse(printed, "printed.toml"));
    } catch (const FatalError& error) {
      require(false, error.what());
    }
    require(print_configuration(again) == printed, "what was printed reads back to the same");
  });
}

}  // namespace
}  // namespace hindsight::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hindsight::fuzz::run({data, size});
  return 0;
}
