// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Reading and printing of a whole configuration: a default-constructible, copyable struct of parameter
// structs (config/params.h) that names its sections.
//
//   struct Configuration {
//     TrackerParams tracker;
//     FlowParams flow;
//     void visit(auto&& section) {
//       section("tracker", tracker);
//       section("perception.flow", flow);
//     }
//   };
//
// The same key means the same thing in every file: files are layered by reading them in turn over one struct.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/config_document.h"
#include "config/config_printer.h"
#include "config/config_reader.h"

namespace hindsight {

/// Overwrites the parameters that the document names. Strict: throws FatalError(kExitConfiguration), one line
/// "FILE:LINE:COLUMN: ..." for each unknown section or key, wrong type or value that is not allowed; `into`
/// is then as it was. An integer is taken for a double, not the other way round.
template <class Configuration>
void read_configuration(Configuration& into, const ConfigDocument& document) {
  Configuration changed = into;
  ConfigReader reader(document);
  changed.visit([&reader](std::string_view section, auto& params) {
    reader.begin_section(section);
    params.visit([&reader](std::string_view key, auto& value, const auto& allowed, std::string_view) {
      reader.read(key, value, allowed);
    });
  });
  reader.finish();
  into = std::move(changed);
}

template <class Configuration>
std::vector<PrintedParam> printed_params(Configuration& configuration) {
  std::vector<PrintedParam> list;
  configuration.visit([&list](std::string_view section, auto& params) {
    params.visit([&](std::string_view key, auto& value, const auto& allowed, std::string_view description) {
      list.push_back({std::string(section), std::string(key), toml_text(value), allowed_text(allowed),
                      std::string(description)});
    });
  });
  return list;
}

/// All parameters as TOML that reads back to exactly the same values, each under a comment: what it is, what
/// is allowed, and its default where the value differs. Not const only because visit() serves the reader too.
template <class Configuration>
std::string print_configuration(Configuration& configuration) {
  Configuration defaults;
  return toml_file(printed_params(configuration), printed_params(defaults));
}

}  // namespace hindsight
