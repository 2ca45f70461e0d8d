// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace hindsight {

/// Replaces `file` so that a crash at any moment leaves the old or the new content, whole: writes a neighbour, syncs
/// it, keeps the old file as FILE.previous, renames, syncs the folder. Returns an empty string or what went wrong.
std::string save_atomically(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

/// Where save_atomically keeps the content before the last.
std::filesystem::path previous_of(const std::filesystem::path& file);

}  // namespace hindsight
