// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace hindsight {

/// A whole file as Bytes: std::string or std::vector<std::uint8_t>. Throws FatalError 66 where it cannot be
/// read.
template <class Bytes>
Bytes read_file(const std::filesystem::path& path);

}  // namespace hindsight
