// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
//
// What the fuzzers share. Each hands bytes to the code that meets them in the program; FatalError and the
// refusals that a header documents are answers like any other, everything else is a finding.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/crc32.h"
#include "config/exit_code.h"

namespace hindsight::fuzz {

using Bytes = std::span<const std::uint8_t>;

inline std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The documented way for bad input to end a program.
template <class Function>
void or_fatal_error(Function function) {
  try {
    function();
  } catch (const FatalError&) {
  }
}

inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

/// Calls check(bytes) with the input, then with a right checksum behind it: what stands behind the check of a
/// saved file is reached.
template <class Check>
void as_it_is_and_sealed(Bytes bytes, Check check) {
  check(bytes);
  std::vector<std::uint8_t> sealed(bytes.begin(), bytes.end());
  const std::uint32_t checksum = crc32(sealed);
  for (unsigned shift = 0; shift < 32; shift += 8)
    sealed.push_back(static_cast<std::uint8_t>(checksum >> shift));
  check(sealed);
}

/// Takes the input apart; beyond its end there are zeros.
class Reader {
 public:
  explicit Reader(Bytes bytes) : bytes_(bytes) {}
  bool empty() const { return bytes_.empty(); }
  Bytes rest() const { return bytes_; }

  template <class Number>
  Number take() {
    Number value{};
    const Bytes bytes = take(sizeof value);
    if (!bytes.empty()) std::memcpy(&value, bytes.data(), bytes.size());
    return value;
  }
  Bytes take(std::size_t count) {
    const Bytes taken = bytes_.first(std::min(count, bytes_.size()));
    bytes_ = bytes_.subspan(taken.size());
    return taken;
  }

 private:
  Bytes bytes_;
};

/// A file that is in memory only, for code that opens its input by name.
class MemoryFile {
 public:
  MemoryFile() : fd_(memfd_create("fuzz", MFD_CLOEXEC)), path_("/proc/self/fd/" + std::to_string(fd_)) {}
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(fd_); }

  const std::string& holding(Bytes bytes) {
    const bool written = ftruncate(fd_, 0) == 0 &&
                         pwrite(fd_, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size());
    require(written, "the file in memory can be written");
    return path_;
  }

 private:
  int fd_;
  std::string path_;
};

}  // namespace hindsight::fuzz
