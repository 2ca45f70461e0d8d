// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// Parameters as TOML text. Used through print_configuration() (config/configuration.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/params.h"

namespace hindsight {

/// One parameter, ready to be written.
struct PrintedParam {
  std::string section;
  std::string key;
  std::string value;    ///< in TOML; numbers in the shortest form that reads back to the same bits
  std::string allowed;  ///< "3 to 31", "one of ...", or empty
  std::string description;
};

std::string toml_text(bool value);
std::string toml_text(int value);
std::string toml_text(double value);
std::string toml_text(std::string_view value);
std::string toml_text(const std::string& value);
std::string toml_text(const std::vector<double>& value);
std::string toml_text(const std::vector<std::string>& value);

std::string allowed_text(const Range& allowed);
std::string allowed_text(const Choices& allowed);
std::string allowed_text(AnyText allowed);
std::string allowed_text(YesNo allowed);

/// The file's text. `defaults` are the same parameters in the same order; a comment names the default of each
/// parameter that differs from it.
std::string toml_file(const std::vector<PrintedParam>& params, const std::vector<PrintedParam>& defaults);

}  // namespace hindsight
