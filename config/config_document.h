// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// A TOML file as plain data: what was written and where. It knows nothing of parameters
// (config/configuration.h).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace hindsight {

/// A place in a file, both counted from 1.
struct ConfigPlace {
  int line = 0;
  int column = 0;
  auto operator<=>(const ConfigPlace&) const = default;
};

/// A value as TOML types it; std::monostate is a type that no parameter has (a date, a nested array).
using ConfigScalar = std::variant<std::monostate, bool, std::int64_t, double, std::string>;
using ConfigValue = std::variant<ConfigScalar, std::vector<ConfigScalar>>;

/// `key = value` inside [section]; section is "" above the first table, "a.b" for [a.b].
struct ConfigEntry {
  std::string section;
  std::string key;
  ConfigValue value;
  std::string value_text;  ///< the value in TOML, on one line, shortened, for messages
  ConfigPlace key_place;
  ConfigPlace value_place;
};

/// A table: [a.b], or a.b implied by a dotted key.
struct ConfigSection {
  std::string name;
  ConfigPlace place;
};

/// Entries and sections in no particular order.
struct ConfigDocument {
  std::string file_name;
  std::vector<ConfigSection> sections;
  std::vector<ConfigEntry> entries;

  /// Throws FatalError(kExitConfiguration), "FILE:LINE:COLUMN: ...", where the text is not TOML 1.0.
  static ConfigDocument parse(std::string_view toml_text, std::string file_name);
  /// Reads and parses a file; FatalError(kExitNoInput) where it cannot be read.
  static ConfigDocument load(const std::string& path);
};

}  // namespace hindsight
