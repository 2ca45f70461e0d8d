// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "tools/experiment_output.h"

#include <fmt/format.h>

#include <fstream>
#include <utility>

#include "config/exit_code.h"

namespace hindsight::tools {
namespace {

std::string markdown_row(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += " " + cell + " |";
  return row + "\n";
}

}  // namespace

std::string ResultTable::markdown() const {
  std::string text = markdown_row(header) + markdown_row(std::vector<std::string>(header.size(), "---"));
  for (const auto& row : rows) text += markdown_row(row);
  return text;
}

ExperimentOutput::ExperimentOutput(std::filesystem::path folder, std::string name)
    : folder_(std::move(folder)), name_(std::move(name)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error)
    throw FatalError(kExitIo,
                     fmt::format("{}: cannot make the folder: {}", folder_.string(), error.message()));
}

std::string ExperimentOutput::path(const std::string& suffix) const {
  return (folder_ / (name_ + suffix)).string();
}

void ExperimentOutput::write(const nlohmann::ordered_json& result, const std::string& markdown) const {
  write_text(".json", result.dump(2) + "\n");
  write_text(".md", markdown);
}

void ExperimentOutput::write_text(const std::string& suffix, const std::string& text) const {
  std::ofstream file(path(suffix));
  file << text;
  if (!file.flush()) throw FatalError(kExitIo, path(suffix) + ": cannot be written");
}

}  // namespace hindsight::tools
