// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// The strict half of reading a configuration: offers each declared parameter its value from the document and
// collects whatever is wrong. Used through read_configuration() (config/configuration.h).
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "config/config_document.h"
#include "config/params.h"

namespace hindsight {

class ConfigReader {
 public:
  explicit ConfigReader(const ConfigDocument& document) : document_(document) {}

  /// The parameters read from here on stand in [name].
  void begin_section(std::string_view name);

  /// Sets `value` if the document holds the key and its value is allowed; otherwise leaves it as it is.
  void read(std::string_view key, bool& value, YesNo allowed);
  void read(std::string_view key, int& value, Range allowed);
  void read(std::string_view key, double& value, Range allowed);
  void read(std::string_view key, std::string& value, AnyText allowed);
  void read(std::string_view key, std::string& value, const Choices& allowed);
  void read(std::string_view key, std::vector<double>& value, Range allowed);
  void read(std::string_view key, std::vector<std::string>& value, AnyText allowed);
  void read(std::string_view key, std::vector<std::string>& value, const Choices& allowed);

  /// Call after the last parameter: looks for sections and keys that nobody declared, then throws
  /// FatalError(kExitConfiguration) if anything was wrong, one line for each error in the order of the file.
  void finish();

 private:
  struct Error {
    ConfigPlace place;
    std::string message;
  };

  template <class T, class Allowed>
  void read_value(std::string_view key, T& value, const Allowed& allowed);
  const ConfigEntry* declare(std::string_view key);
  void find_unknown_sections();
  void find_unknown_keys();
  bool is_declared_or_parent(const std::string& section) const;

  const ConfigDocument& document_;
  std::string section_;
  std::map<std::string, std::set<std::string>> declared_;  ///< keys by section
  std::vector<Error> errors_;
};

}  // namespace hindsight
