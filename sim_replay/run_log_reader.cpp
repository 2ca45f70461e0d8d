// SPDX-FileCopyrightText: 2026 The Hindsight authors
// SPDX-License-Identifier: BSD-2-Clause
#include "sim_replay/run_log_reader.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "config/exit_code.h"
#include "sim_replay/big_endian.h"
#include "sim_replay/event_log_format.h"

namespace hindsight {
namespace {

constexpr std::size_t kWindowBytes = std::size_t{256} << 10;
constexpr std::size_t kSyncBytes = 4;

std::uint64_t regular_file_size(int descriptor, const std::string& path) {
  struct stat status {};
  if (descriptor < 0 || ::fstat(descriptor, &status) != 0) {
    throw FatalError(kExitNoInput, fmt::format("{}: cannot open the log: {}", path, std::strerror(errno)));
  }
  if (!S_ISREG(status.st_mode)) throw FatalError(kExitNoInput, fmt::format("{}: not a regular file", path));
  return static_cast<std::uint64_t>(status.st_size);
}

}  // namespace

RunLogReader::Descriptor::~Descriptor() {
  if (value >= 0) ::close(value);
}

RunLogReader::RunLogReader(const std::filesystem::path& path, bool recover)
    : path_(path.string()), descriptor_{::open(path.c_str(), O_RDONLY | O_CLOEXEC)} {
  size_ = regular_file_size(descriptor_.value, path_);
  if (size_ == 0)
    throw FatalError(kExitBadData, fmt::format("{}: the file is empty, not an LCM event log", path_));
  const bool believable = recover ? find_sync(0, size_) < size_ : sync_at(0);
  if (!believable) {
    throw FatalError(
        kExitBadData,
        fmt::format("{}: byte 0: not an LCM event log (expected the sync word 0x{:08X})", path_, kEventSync));
  }
}

RunLogReader::Result RunLogReader::next() {
  if (position_ >= size_) return Result::end;
  const std::uint64_t start = position_;
  const std::uint64_t left = size_ - start;
  if (left >= kSyncBytes && !sync_at(start)) {
    return report_damage(start, find_sync(start + 1, size_),
                         fmt::format("expected the sync word 0x{:08X}", kEventSync));
  }
  if (left < kEventHeaderBytes) {
    return report_damage(start, size_,
                         fmt::format("the file ends after {} bytes of an event's header", left));
  }
  const std::uint8_t* const header = bytes_at(start, kEventHeaderBytes);
  const auto number = read_big_endian<std::int64_t>(header + 4);
  const auto time_us = read_big_endian<std::int64_t>(header + 12);
  const auto channel_length = read_big_endian<std::uint32_t>(header + 20);
  const auto data_length = read_big_endian<std::uint32_t>(header + 24);
  if (channel_length == 0 || channel_length > kMaxChannelLength || data_length > kMaxEventBytes) {
    return report_damage(
        start, find_sync(start + kSyncBytes, size_),
        fmt::format("an event declares a channel of {} and data of {} bytes", channel_length, data_length));
  }
  const std::uint64_t total = kEventHeaderBytes + std::uint64_t{channel_length} + data_length;
  if (total > left) {
    return report_damage(start, find_sync(start + kSyncBytes, size_),
                         fmt::format("an event declares {} bytes, but the file ends after {}", total, left));
  }
  const std::uint64_t end = start + total;
  if (end < size_ && !sync_at(end)) {
    // Either this event's length is wrong or the next event is damaged. A sync word inside says which.
    const std::uint64_t inner = find_sync(start + kSyncBytes, end);
    if (inner < end) return report_damage(start, inner, "an event's length reaches into the next event");
  }
  const std::uint8_t* const bytes = bytes_at(start, total);
  const auto* const channel = reinterpret_cast<const char*>(bytes + kEventHeaderBytes);
  event_ = {start,
            number,
            time_us,
            {channel, channel_length},
            {bytes + kEventHeaderBytes + channel_length, data_length}};
  position_ = end;
  return Result::event;
}

RunLogReader::Result RunLogReader::report_damage(std::uint64_t offset, std::uint64_t resume_at,
                                                 std::string reason) {
  damage_ = {offset, std::move(reason)};
  position_ = resume_at;
  return Result::damage;
}

bool RunLogReader::sync_at(std::uint64_t offset) {
  return size_ - offset >= kSyncBytes &&
         read_big_endian<std::uint32_t>(bytes_at(offset, kSyncBytes)) == kEventSync;
}

/// First offset in [from, to) at which a sync word begins (it may reach beyond `to`), or the file's size.
std::uint64_t RunLogReader::find_sync(std::uint64_t from, std::uint64_t to) {
  const std::array<std::uint8_t, kSyncBytes> word{0xED, 0xA1, 0xDA, 0x01};
  while (from < to && size_ - from >= kSyncBytes) {
    const std::size_t count =
        std::min<std::uint64_t>(kWindowBytes, std::min(to + kSyncBytes - 1, size_) - from);
    const std::uint8_t* const bytes = bytes_at(from, count);
    const auto* const found = std::search(bytes, bytes + count, word.begin(), word.end());
    if (found != bytes + count) return from + static_cast<std::uint64_t>(found - bytes);
    from += count - (kSyncBytes - 1);
  }
  return size_;
}

/// `count` bytes of the file from `offset` on, which the caller has checked to exist; valid until the next
/// call.
const std::uint8_t* RunLogReader::bytes_at(std::uint64_t offset, std::size_t count) {
  if (offset < window_start_ || offset + count > window_start_ + window_size_) fill_window(offset, count);
  return window_.data() + (offset - window_start_);
}

void RunLogReader::fill_window(std::uint64_t offset, std::size_t count) {
  const std::size_t wanted = std::min<std::uint64_t>(std::max(count, kWindowBytes), size_ - offset);
  if (window_.size() < wanted) window_.resize(wanted);
  window_start_ = offset;
  window_size_ = 0;
  while (window_size_ < wanted) {
    const ssize_t got = ::pread(descriptor_.value, window_.data() + window_size_, wanted - window_size_,
                                static_cast<off_t>(offset + window_size_));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) {
      throw FatalError(kExitIo, fmt::format("{}: byte {}: cannot read: {}", path_, offset + window_size_,
                                            got < 0 ? std::strerror(errno) : "the file has become shorter"));
    }
    window_size_ += static_cast<std::size_t>(got);
  }
}

}  // namespace hindsight
