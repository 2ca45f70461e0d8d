// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
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

/// Where to look for what was saved, in this order, for a whole one: FILE, its previous content, and what a killed save
/// had synced but not yet renamed, which is the only whole one if FILE was damaged before that save.
std::array<std::filesystem::path, 3> saved_copies_of(const std::filesystem::path& file);

}  // namespace hindsight
