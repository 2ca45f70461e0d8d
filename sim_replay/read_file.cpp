// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/read_file.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <string>

#include "config/exit_code.h"

namespace hindsight {

template <class Bytes>
Bytes read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || !std::filesystem::is_regular_file(path)) {
    throw FatalError(kExitNoInput, fmt::format("{}: no such file", path.string()));
  }
  Bytes bytes(std::filesystem::file_size(path), {});
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file) throw FatalError(kExitNoInput, fmt::format("{}: cannot read the file", path.string()));
  return bytes;
}

template std::string read_file(const std::filesystem::path& path);
template std::vector<std::uint8_t> read_file(const std::filesystem::path& path);

}  // namespace hindsight
