// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What an experiment leaves: NAME.json, NAME.md with a table, and pictures.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace hindsight::tools {

/// A table for people; numbers come as text, so that each has the digits that it deserves.
struct ResultTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;

  std::string markdown() const;
};

class ExperimentOutput {
 public:
  /// Makes the folder. FatalError 74 where that is not possible.
  ExperimentOutput(std::filesystem::path folder, std::string name);

  void write(const nlohmann::ordered_json& result, const std::string& markdown) const;
  /// A file of the experiment's: NAME + suffix.
  std::string path(const std::string& suffix) const;

 private:
  void write_text(const std::string& suffix, const std::string& text) const;

  std::filesystem::path folder_;
  std::string name_;
};

}  // namespace hindsight::tools
