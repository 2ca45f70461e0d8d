// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "daemon/model_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "drivers/unique_fd.h"

namespace hindsight {
namespace {

std::string problem(const char* what, const std::filesystem::path& path) {
  return fmt::format("{}: cannot {}: {}", path.string(), what, std::strerror(errno));
}

bool write_all(int fd, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

std::string write_and_sync(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  const UniqueFd fd(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  if (!fd) return problem("create", path);
  if (!write_all(fd.get(), bytes)) return problem("write", path);
  if (fsync(fd.get()) != 0) return problem("sync", path);
  return {};
}

std::string sync_folder(const std::filesystem::path& folder) {
  const UniqueFd fd(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!fd || fsync(fd.get()) != 0) return problem("sync", folder);
  return {};
}

std::filesystem::path fresh_of(const std::filesystem::path& file) { return file.string() + ".new"; }

}  // namespace

std::filesystem::path previous_of(const std::filesystem::path& file) { return file.string() + ".previous"; }

std::array<std::filesystem::path, 3> saved_copies_of(const std::filesystem::path& file) {
  return {file, previous_of(file), fresh_of(file)};
}

std::string save_atomically(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
  const std::filesystem::path fresh = fresh_of(file);
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (std::string error = write_and_sync(fresh, bytes); !error.empty()) return error;
  // A hard link keeps the old content under both names until the rename, so `file` is never missing.
  unlink(previous_of(file).c_str());
  if (link(file.c_str(), previous_of(file).c_str()) != 0 && errno != ENOENT) return problem("keep a copy of", file);
  if (rename(fresh.c_str(), file.c_str()) != 0) return problem("replace", file);
  return sync_folder(folder);
}

}  // namespace hindsight
